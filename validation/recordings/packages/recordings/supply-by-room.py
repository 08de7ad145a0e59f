"""The 12 V supply of a logger on a bench, indoors, a day of minutes, with the temperature of a thermometer in the room, which falls from 20 degC to 18 and is warmed to 28 once. The supply changes with its temperature."""

from models.fitting import line, terms
from models.lags import lag
from readers.nrgpy import mast_logger, own_supplies

HAND_BUILT = "temperature, and drift"


def rows(diagnosis, readings):
    supply = own_supplies(diagnosis, "ALG_12V0")
    room = mast_logger(readings)[["when", "Ch1_Avg_deg_C"]]
    both = supply.merge(room, on="when")
    return {"time_s": both.time_s, "room_c": both.Ch1_Avg_deg_C, "supply_mv": both.ALG_12V0}


def models(c):
    y, warm, t = c["supply_mv"], c["room_c"], c["time_s"]
    late = lambda p: lag(warm, t, abs(p) * 600)
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "temperature": line(y, warm),
        "temperature, bent": line(y, warm, warm**2),
        "late temperature": terms(y, lambda p: [late(p[0])], [1.0]),
        "temperature, and late temperature": terms(y, lambda p: [warm, late(p[0])], [1.0]),
        HAND_BUILT: line(y, warm, t),
        "temperature, bent, and drift": line(y, warm, warm**2, t),
    }
