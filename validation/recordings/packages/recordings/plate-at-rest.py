"""Sideways force of a force plate that nobody stands on, a minute, 50 rows a second. Its zero moves by next to nothing."""

import numpy as np
from models.fitting import line, terms
from readers.gaitanalysistoolkit import bare_plates

HAND_BUILT = "exponential"


def rows(content):
    frame = bare_plates(content, "FP1.ForX")
    return {"time_s": frame.time_s, "force_n": frame["FP1.ForX"]}


def models(c):
    y, t = c["force_n"], c["time_s"]
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        HAND_BUILT: terms(y, lambda p: [np.exp(-t / (abs(p[0]) + 1))], [20.0]),
        "logarithm": terms(y, lambda p: [np.log1p(t / (abs(p[0]) + 1))], [20.0]),
    }
