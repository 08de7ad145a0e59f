"""Pressure that a current profiler on a glider tells, over that of the CTD on the same glider, dives to 70 m for 2.7 hours, a row each 30 s. The profiler's row was taken some 12 s before the CTD's."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag, usual
from readers.pyglider import glider

HAND_BUILT = "shift, as a series"


def rows(*contents):
    frame = glider(*contents)
    frame = frame[frame.AD2CP_PRESSURE.notna() & (frame.LEGATO_PRESSURE < 9000)]
    return {"time_s": frame.time_s, "ctd_dbar": frame.LEGATO_PRESSURE, "profiler_dbar": frame.AD2CP_PRESSURE}


def models(c):
    y, x, t = c["profiler_dbar"], c["ctd_dbar"], c["time_s"]
    at = lambda p: np.interp(t - p * 10, t, x)
    return y, {
        **usual(y, x, t, 30),
        "shift, begun ahead": terms(y, lambda p: [at(p[0])], [-1.0]),
        HAND_BUILT: line(y, x, np.gradient(x, t), np.gradient(np.gradient(x, t), t)),
        "shift, and square": terms(y, lambda p: [at(p[0]), at(p[0]) ** 2], [-1.0]),
        "shift, and lag": terms(y, lambda p: [lag(at(p[0]), t, abs(p[1]) * 10)], [-1.0, 0.3]),
    }
