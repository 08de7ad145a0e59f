"""Counts of two isotopes of magnesium while a laser burns a standard, one after the other in each sweep of 0.36 s; the simulation is the one by their shares in nature. They agree."""

import numpy as np
from fitting import lag, line, terms
from reading import csv

HAND_BUILT = "line"


def rows(content):
    frame = csv(content, skiprows=3).dropna()
    frame = frame[frame["Mg24"].notna()].astype(float)
    return {"time_s": frame["Time [Sec]"], "first_cps": frame["Mg24"] * 10.00 / 78.99, "second_cps": frame["Mg25"]}


def models(c):
    y, x, t = c["second_cps"], c["first_cps"], c["time_s"]
    return y, {
        HAND_BUILT: line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 0.36, t, x)], [0.5]),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 0.36)], [0.5]),
    }
