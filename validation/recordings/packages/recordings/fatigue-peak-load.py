"""Largest load of each cycle of a fatigue test whose strain is held, a quarter of an hour, every second line of its file. The material softens."""

import numpy as np
from models.fitting import line, terms
from readers.pyfat import fatigue_cycles

HAND_BUILT = "logarithm"


def rows(content):
    frame = fatigue_cycles(content).iloc[::2]
    return {"time_s": frame.time_s, "load_kn": frame.load_kn}


def models(c):
    y, t = c["load_kn"], c["time_s"]
    fades = lambda p: np.exp(-t / (abs(p[0]) * t[-1]))
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "square": line(y, t, t**2),
        "exponential": terms(y, lambda p: [fades(p)], [0.1]),
        "exponential, and drift": terms(y, lambda p: [fades(p), t], [0.05]),
        HAND_BUILT: line(y, np.log(t + 1)),
    }
