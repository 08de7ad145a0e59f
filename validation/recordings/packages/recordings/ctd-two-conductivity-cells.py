"""Two conductivity cells of one CTD, the whole lowering; the first cell fails below 920 dbar. No model beat the line on rows left out."""

from models.fitting import line
from readers.cotede import ctd_cast

HAND_BUILT = "line"


def rows(content):
    d = ctd_cast(content, None)
    return {"time_s": d.timeS.round(3), "water_c": d.TEMP2, "depth": d.PRES, "second_cell": d.CNDC2 * 10, "first_cell": d.CNDC * 10}


def models(c):
    y, x = c["first_cell"], c["second_cell"]
    return y, {HAND_BUILT: line(y, x), "and depth": line(y, x, c["depth"])}
