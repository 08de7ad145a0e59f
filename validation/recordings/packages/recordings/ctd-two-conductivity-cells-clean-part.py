"""Two conductivity cells of one CTD, the first 820 rows, before the failure: nothing is missing."""

from models.fitting import line
from readers.cotede import ctd_cast

HAND_BUILT = "line"


def rows(content):
    d = ctd_cast(content, 820)
    return {"time_s": d.timeS.round(3), "water_c": d.TEMP2, "depth": d.PRES, "second_cell": d.CNDC2 * 10, "first_cell": d.CNDC * 10}


def models(c):
    y, x = c["first_cell"], c["second_cell"]
    return y, {HAND_BUILT: line(y, x), "and depth": line(y, x, c["depth"])}
