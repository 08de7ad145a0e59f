"""The supply of -15 V of a logger over its supply of +15 V, indoors, a day of minutes. Both are made in one box, so that they change together."""

from models.fitting import line
from models.lags import usual
from readers.nrgpy import mast_logger, own_supplies

HAND_BUILT = "line"


def rows(diagnosis, readings):
    supply = own_supplies(diagnosis, "ALG_15V1_POS", "ALG_15V1_NEG")
    room = mast_logger(readings)[["when", "Ch1_Avg_deg_C"]]
    both = supply.merge(room, on="when")
    return {"time_s": both.time_s, "room_c": both.Ch1_Avg_deg_C, "plus_mv": both.ALG_15V1_POS, "minus_mv": both.ALG_15V1_NEG}


def models(c):
    y, x, t, warm = c["minus_mv"], c["plus_mv"], c["time_s"], c["room_c"]
    return y, {
        **usual(y, x, t),
        "temperature": line(y, x, warm),
        "temperature, and drift": line(y, x, warm, t),
    }
