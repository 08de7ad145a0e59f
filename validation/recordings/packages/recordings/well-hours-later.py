"""How turbid one well of a plate is over another one, 24 h. What grows in it begins hours later."""

from durations import HOUR
from formats.plate_reader import densities
from models.lags import late_shifts

HAND_BUILT = "shift from there"


def rows(content):
    told = densities(content, "C11", "C10")
    return {"time_s": told["time_s"], "early_od": told["C11"], "late_od": told["C10"]}


def models(c):
    y, x, t = c["late_od"], c["early_od"], c["time_s"]
    return y, late_shifts(y, x, t, HOUR, 6.0)
