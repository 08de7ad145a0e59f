"""Voltage of a fresh cell that is discharged by 1.89 mA, beside that of an aged one of its kind at the same time after the start, until the aged one is empty.

The fresh one holds more, so all comes later. Every fourth row.
"""

import numpy as np
from formats.text import csv
from models.fitting import line, terms

HAND_BUILT = "aged cell, slower"


def rows(fresh, aged):
    fresh, aged = csv(fresh), csv(aged)
    fresh = fresh[fresh.Seconds <= aged.Seconds.max()].iloc[::4]
    return {"time_s": fresh.Seconds, "aged_v": np.interp(fresh.Seconds, aged.Seconds, aged.Volts), "fresh_v": fresh.Volts}


def models(c):
    y, x, t = c["fresh_v"], c["aged_v"], c["time_s"]

    def slower(p):
        return [np.interp(t * (1 - p[0]) + p[1] * 100, t, x)]

    def bent(p):
        return [slower(p)[0] ** power for power in (1, 2)]

    return y, {
        "line": line(y, x),
        "cubic": line(y, x, x**2, x**3),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 1000, t, x)], [2.0]),
        HAND_BUILT: terms(y, slower, [0.1, 0.0]),
        "slower, and drift": terms(y, lambda p: [*slower(p), t], [0.1, 0.0]),
        "slower, and bent": terms(y, bent, [0.1, 0.0]),
    }
