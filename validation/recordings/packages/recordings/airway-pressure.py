"""Pressure at the mouth over the flow of breath, 125 Hz, twenty seconds. It bends."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag

HAND_BUILT = "square"
CHANNELS, ROWS, AT = 4, 2455, 41676


def rows(content):
    flow, _, mouth, _ = np.frombuffer(content, "<f8", CHANNELS * ROWS, AT).reshape(ROWS, CHANNELS).T
    return {"time_s": np.arange(ROWS) / 125, "flow_l_s": flow, "mouth_cmh2o": mouth}


def models(c):
    y, x, t = c["mouth_cmh2o"], c["flow_l_s"], c["time_s"]
    return y, {
        "line": line(y, x),
        HAND_BUILT: line(y, x, x**2),
        "cubic": line(y, x, x**2, x**3),
        "square by size": line(y, x, x * np.abs(x)),
        "drift": line(y, x, t),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 0.1, t, x)], [0.1]),
        "line and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 0.1)], [1.0]),
    }
