"""Thermometer inside of a soil reflectometer over thermocouples in the soil near it, eight days of spring, a row each half hour. Its heat comes later than theirs."""

from models.fitting import terms
from models.lags import lag, usual
from readers.micromet import tob1

HAND_BUILT = "bent lag"


def rows(content):
    frame = tob1(content)
    return {"time_s": frame.time_s, "thermocouples_c": frame.TS_2_1_1, "reflectometer_c": frame.TS_CS65X_2_1_1}


def models(c):
    y, x, t = c["reflectometer_c"], c["thermocouples_c"], c["time_s"]
    late = lambda p: lag(x, t, abs(p) * 3600)
    return y, {
        **usual(y, x, t, 3600),
        "line and lag": terms(y, lambda p: [x, late(p[0])], [2.0]),
        "lag, and drift": terms(y, lambda p: [late(p[0]), t], [2.0]),
        HAND_BUILT: terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [2.0]),
        "two lags": terms(y, lambda p: [lag(late(p[0]), t, abs(p[1]) * 3600)], [2.0, 1.0]),
    }
