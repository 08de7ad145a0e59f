"""How turbid one well of a plate is over another one, 24 h. What grows in it begins hours later."""

from gauges import HOUR, later
from meters import plate

HAND_BUILT = "shift from there"


def rows(content):
    told = plate(content, "C11", "C10")
    return {"time_s": told["time_s"], "early_od": told["C11"], "late_od": told["C10"]}


def models(c):
    y, x, t = c["late_od"], c["early_od"], c["time_s"]
    return y, later(y, x, t, HOUR, 6.0)
