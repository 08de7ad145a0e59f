"""Outlets of two rows of a field of solar collectors under passing clouds, 1 min, six hours. The first row is some seconds behind the second."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.sunpeek_exampledata import collectors

HAND_BUILT = "line and lag"


def rows(content):
    frame = collectors(content, "2017-05-11 08:00", "2017-05-11 14:00", 1)
    return {"time_s": frame.time_s, "second_k": frame.te_out_row2, "first_k": frame.te_out_row1}


def models(c):
    y, x, t = c["first_k"], c["second_k"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 60, t, x)], [0.1]),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 60)], [0.3]),
        HAND_BUILT: terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 60)], [1.0]),
    }
