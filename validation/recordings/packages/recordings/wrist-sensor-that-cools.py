"""Warmth of an accelerometer that is worn at the wrist, each half a second of three minutes."""

import numpy as np
from models.fitting import line, scaled, terms
from readers.gaitpy import wrist_sensor

HAND_BUILT = "logarithm from a time"


def rows(content):
    return wrist_sensor(content, 25)


def models(c):
    y, t = c["sensor_degc"], c["time_s"]
    v, none = scaled(t), np.zeros(len(t))
    fades = lambda p: np.exp(-t / (abs(p) * 100 + 1))
    return y, {
        "mean": line(y, none),
        "drift": line(y, v),
        "drift, and its square": line(y, v, v**2),
        "cube of the drift": line(y, v, v**2, v**3),
        "logarithm": line(y, np.log1p(t / 10)),
        "logarithm from a time": terms(y, lambda p: [np.log1p(t / (abs(p[0]) + 0.1))], [10.0]),
        "what fades": terms(y, lambda p: [fades(p[0])], [1.0]),
        "what fades, and drift": terms(y, lambda p: [fades(p[0]), v], [0.3]),
        "step": terms(y, lambda p: [np.tanh((t - p[0]) / 5)], [60.0]),
    }
