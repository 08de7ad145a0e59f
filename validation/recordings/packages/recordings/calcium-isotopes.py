"""Counts of two isotopes of calcium while a laser burns a shell, one after the other in each sweep of 0.36 s; the simulation is the one by their shares in nature. Next to nothing is missing: the second comes later in a sweep."""

import numpy as np
from fitting import lag, line, terms
from reading import csv

HAND_BUILT = "shift"


def rows(content):
    frame = csv(content, skiprows=3).dropna()
    frame = frame[frame["Ca43"].notna()].astype(float)
    return {"time_s": frame["Time [Sec]"], "first_cps": frame["Ca43"] * 2.086 / 0.135, "second_cps": frame["Ca44"]}


def models(c):
    y, x, t = c["second_cps"], c["first_cps"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        HAND_BUILT: terms(y, lambda p: [np.interp(t - p[0] * 0.36, t, x)], [0.5]),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 0.36)], [0.5]),
    }
