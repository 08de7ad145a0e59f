"""Thermometers of two soil probes, one deeper than the other, 15 min, a summer month. The deeper one follows late, and less."""

import numpy as np
from models.cycles import tone
from models.fitting import line, terms
from models.lags import lag
from readers.neptoon import soil_logger

HAND_BUILT = "two lags"


def rows(content):
    t, frame = soil_logger(content)
    return {"time_s": t, "upper_c": frame[12], "lower_c": frame[16]}


def models(c):
    y, x, t = c["lower_c"], c["upper_c"], c["time_s"]
    return y, {
        "line": line(y, x),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 3600, t, x)], [2.0]),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 3600)], [5.0]),
        "line and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 3600)], [5.0]),
        HAND_BUILT: terms(y, lambda p: [lag(x, t, abs(q) * 3600) for q in p], [3.0, 20.0]),
        "hours of the day": line(y, x, *tone(t, 86400)),
    }
