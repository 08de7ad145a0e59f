"""Pressure of gas that was compressed and did not burn, as it cools behind the piston."""

import numpy as np
from models.fitting import line, scaled, terms
from readers.uconnrcmpy import slow_shots

HAND_BUILT = "drift that fades"


def rows(content):
    return slow_shots(content, begin=0.25, rows=500)


def models(c):
    y, t = c["first_v"], c["time_s"]
    w, fading = scaled(t), lambda p: np.exp(-t / abs(p))
    return y, {
        "constant": line(y, np.ones(len(y))),
        "drift": line(y, w),
        "drift, and its square": line(y, w, w**2),
        "logarithm": terms(y, lambda p: [np.log(1 + t / abs(p[0]))], [0.2]),
        "power": terms(y, lambda p: [(1 + t / abs(p[0])) ** -p[1]], [1.0, 1.0]),
        "drift that fades": terms(y, lambda p: [fading(p[0])], [1.0]),
        "drift that fades, and drift": terms(y, lambda p: [fading(p[0]), w], [1.0]),
        "two drifts that fade": terms(y, lambda p: [fading(p[0]), fading(p[1])], [1.0, 0.2]),
    }
