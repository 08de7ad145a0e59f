"""Roll of a glider over the angle to which it turns its battery, three dives. Next to nothing is missing."""

import numpy as np
from models.fitting import line
from models.lags import usual_and_lags
from readers.seagliderog1 import warm_glider

HAND_BUILT = "drift"


def rows(content):
    frame = warm_glider(content, 9, 11, 10, "roll", "battery")
    return {"time_s": frame.time_s, "battery_deg": frame.battery, "roll_deg": frame.roll}


def models(c):
    y, x, t = c["roll_deg"], c["battery_deg"], c["time_s"]
    turns = np.where(np.abs(np.diff(x, prepend=x[0])) > 1, np.sign(np.diff(x, prepend=x[0])), np.nan)
    last = np.maximum.accumulate(np.where(np.isnan(turns), 0, np.arange(len(x))))
    side = np.nan_to_num(turns[last])
    return y, {
        **usual_and_lags(y, x, t, 20),
        "cube": line(y, x, x**2, x**3),
        "friction": line(y, x, side),
        "friction, and drift": line(y, x, side, t),
        "slope that drifts": line(y, x, t, x * t),
    }
