"""What a controller tells the exhaust valve of a soot photometer to do, over the flow of air that it is to hold, a row a second, half an hour. It answers a flow that is too large one row later."""

import numpy as np
from formats.soot_photometer import photometer
from models.fitting import line, terms
from models.lags import usual

HAND_BUILT = "flow one row and two rows before"


def rows(content):
    frame = photometer(content, flow_cm3_min="Sample Flow LFE (vccm)", valve_v="Exhaust Valve SP (Volts)").iloc[:2000]
    return {**frame, "time_s": (frame.time_s - frame.time_s.iloc[0]).round(3)}


def models(c):
    y, x, t = c["valve_v"], c["flow_cm3_min"], c["time_s"]
    before = lambda rows: np.append(np.full(rows, x[0]), x[:-rows])
    return y, {
        **usual(y, x, t, 2),
        "flow, and flow a second before": terms(y, lambda p: [x, np.interp(t - p[0], t, x)], [1.0]),
        "flow one row before": line(y, before(1)),
        HAND_BUILT: line(y, before(1), before(2)),
    }
