"""Electrical conductivity of soil over the water that the same reflectometer finds in it, beside its temperature, eight dry days, a row each half hour. Water conducts better where it is warm, by some 2 % per K."""

from models.fitting import line, terms
from models.lags import lag, usual
from readers.micromet import tob1

HAND_BUILT = "gain by temperature"


def rows(content):
    frame = tob1(content)
    return {"time_s": frame.time_s, "water_percent": frame.SWC_1_1_1, "soil_c": frame.TS_1_1_1, "conductivity_ds_m": frame.cs65x_ec_1_1_1}


def models(c):
    y, x, t, warm = c["conductivity_ds_m"], c["water_percent"], c["time_s"], c["soil_c"]
    late = lambda p: lag(warm, t, abs(p) * 3600)
    return y, {
        **usual(y, x, t, 3600),
        "temperature": line(y, x, warm),
        HAND_BUILT: line(y, x, x * warm),
        "late temperature": terms(y, lambda p: [x, late(p[0])], [1.0]),
        "temperature, and late temperature": terms(y, lambda p: [x, warm, late(p[0])], [5.0]),
        "temperature, and drift": line(y, x, warm, t),
        "temperature, and square": line(y, x, x**2, warm),
    }
