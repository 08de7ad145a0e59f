"""Volts of a membrane in front of a wall that hydrogen goes through, nearly four days."""

import numpy as np
from durations import DAY
from models.cycles import tone
from models.fitting import line, scaled, terms
from readers.shield_data import permeation

HAND_BUILT = "drift"


def rows(content):
    return permeation(content, 400, "upper_v", begin=600)


def models(c):
    y, t = c["upper_v"], c["time_s"]
    w, day = scaled(t), tone(t, DAY)
    return y, {
        "constant": line(y),
        "drift": line(y, w),
        "drift, and its square": line(y, w, w**2),
        "drift, its square and cube": line(y, w, w**2, w**3),
        "drift by the logarithm": line(y, np.log(t + 3600)),
        "drift to a rest": terms(y, lambda p: [np.exp(-t / ((0.1 + abs(p[0])) * DAY))], [3.0]),
        "day": line(y, *day),
        "drift, and day": line(y, w, *day),
        "drift, day, and half a day": line(y, w, *day, *tone(t, DAY / 2)),
    }
