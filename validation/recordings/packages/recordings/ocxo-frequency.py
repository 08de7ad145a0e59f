"""Frequency of an oven crystal oscillator over hours: it wanders, and no column tells why."""

import numpy as np
from models.fitting import line
from readers.allantools import numbers

HAND_BUILT = "line in time"


def rows(content):
    deviation = numbers(content) - 1e7
    n = len(deviation) // 20
    return {"time_s": (np.arange(n) + 0.5) * 20, "deviation_mhz": deviation[: n * 20].reshape(n, 20).mean(axis=1) * 1e3}


def models(c):
    y = c["deviation_mhz"]
    return y, {"constant": line(y), HAND_BUILT: line(y, c["time_s"])}
