"""Voltage that a logger gives to its second pair of channels, where a barometer takes 1.2 mA, over that of its fifth pair, where wind vanes take 0.1 mA, indoors, a day of minutes. Both are made alike."""

from models.fitting import line, terms
from models.lags import lag, usual
from readers.nrgpy import mast_logger, own_supplies

HAND_BUILT = "drift"


def rows(diagnosis, readings):
    supply = own_supplies(diagnosis, "ALG_EXC_V_P2", "ALG_EXC_V_P5")
    room = mast_logger(readings)[["when", "Ch1_Avg_deg_C"]]
    both = supply.merge(room, on="when")
    return {"time_s": both.time_s, "room_c": both.Ch1_Avg_deg_C, "vanes_mv": both.ALG_EXC_V_P5, "barometer_mv": both.ALG_EXC_V_P2}


def models(c):
    y, x, t, warm = c["barometer_mv"], c["vanes_mv"], c["time_s"], c["room_c"]
    late = lambda p: lag(warm, t, abs(p) * 600)
    return y, {
        **usual(y, x, t),
        "temperature": line(y, x, warm),
        "late temperature": terms(y, lambda p: [x, late(p[0])], [1.0]),
        "temperature, and late temperature": terms(y, lambda p: [x, warm, late(p[0])], [1.0]),
        "temperature, and drift": line(y, x, warm, t),
    }
