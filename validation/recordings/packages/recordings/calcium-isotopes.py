"""Counts of two isotopes of calcium while a laser burns a shell, one after the other in each sweep of 0.36 s; the simulation is the one by their shares in nature. Next to nothing is missing: the second comes later in a sweep."""

from models.lags import usual
from readers.latools import isotopes

HAND_BUILT = "shift"


def rows(content):
    frame = isotopes(content, "Ca43")
    return {"time_s": frame["Time [Sec]"], "first_cps": frame["Ca43"] * 2.086 / 0.135, "second_cps": frame["Ca44"]}


def models(c):
    y, x, t = c["second_cps"], c["first_cps"], c["time_s"]
    return y, usual(y, x, t, unit=0.36)
