"""Thermistor in the dome of a pyrgeometer that looks at the ground, over the one in its case, a day in June, every minute: the dome is the warmer, the more heat comes up from the ground."""

import numpy as np
from formats.netcdf import netcdf
from models.fitting import line, terms
from models.lags import lag

HAND_BUILT = "thermopile, by resistance"


def rows(content):
    names = {"case_kohm": "inst_up_long_case_resist", "thermopile_mv": "inst_up_long_hemisp_tp", "dome_kohm": "inst_up_long_dome_resist"}
    d = netcdf(content, names).iloc[::3]
    return {"time_s": np.arange(len(d)) * 60.0, **{name: d[name] for name in names}}


def models(c):
    y, x, t, heat = c["dome_kohm"], c["case_kohm"], c["time_s"], c["thermopile_mv"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 60)], [5.0]),
        "thermopile": line(y, x, heat),
        HAND_BUILT: line(y, x, heat, heat * x),
        "square and thermopile": line(y, x, x**2, heat),
        "thermopile, and its lag": terms(y, lambda p: [x, heat, lag(heat, t, abs(p[0]) * 60)], [10.0]),
    }
