"""Height of a sample of soil under a new load, a day in an oedometer. Water is pressed out of it, by an exponential, and it creeps on with the logarithm of the time."""

import numpy as np
from formats.text import csv
from models.fitting import line, terms

HAND_BUILT = "logarithm, and drift that fades"


def rows(content):
    frame = csv(content)
    return {"time_s": frame.iloc[:, 0].round(6), "height_mm": frame.iloc[:, 1].round(3)}


def pressed_out(p, t):
    """The part of the water that is not yet pressed out of a layer, by Terzaghi's series."""
    odd = np.arange(1, 40, 2)[:, None]
    return (8 / (np.pi * odd) ** 2 * np.exp(-((odd * np.pi) ** 2) / 4 * t / (abs(p) * 1000 + 1))).sum(axis=0)


def models(c):
    y, t = c["height_mm"], c["time_s"]
    fading = lambda p: np.exp(-t / (abs(p) * 100 + 0.1))
    slow = lambda p: np.log1p(t / (abs(p) * 10 + 0.1))
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "drift that fades": terms(y, lambda p: [fading(p[0])], [1.0]),
        "two drifts that fade": terms(y, lambda p: [fading(p[0]), fading(p[1])], [0.3, 10.0]),
        "logarithm": terms(y, lambda p: [slow(p[0])], [1.0]),
        "logarithm, and drift": terms(y, lambda p: [slow(p[0]), t], [1.0]),
        "root that fades": terms(y, lambda p: [np.exp(-np.sqrt(t / (abs(p[0]) * 100 + 0.1)))], [1.0]),
        "consolidation": terms(y, lambda p: [pressed_out(p[0], t)], [0.5]),
        "consolidation, and logarithm": terms(y, lambda p: [pressed_out(p[0], t), slow(p[1])], [0.5, 1.0]),
        "logarithm, and drift that fades": terms(y, lambda p: [slow(p[0]), fading(p[1])], [1.0, 3.0]),
    }
