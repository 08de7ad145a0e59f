"""Counts of two isotopes of magnesium while a laser burns a standard, one after the other in each sweep of 0.36 s; the simulation is the one by their shares in nature. They agree."""

from models.lags import usual
from readers.latools import isotopes

HAND_BUILT = "line"


def rows(content):
    frame = isotopes(content, "Mg24")
    return {"time_s": frame["Time [Sec]"], "first_cps": frame["Mg24"] * 10.00 / 78.99, "second_cps": frame["Mg25"]}


def models(c):
    y, x, t = c["second_cps"], c["first_cps"], c["time_s"]
    return y, usual(y, x, t, unit=0.36)
