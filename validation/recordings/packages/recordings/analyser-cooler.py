"""Voltage of the cooler of the detector of a gas analyser over the temperature of the air, beside the sunshine on it, half hours of the second fortnight of July in which it ran."""

from models.fitting import line, terms
from models.lags import lag, usual
from readers.diive import tower

HAND_BUILT = "late sunshine"
SECOND_WINDOW = 864000  # s


def rows(content):
    frame = tower(content, "TA_1_1_1", "SW_IN_1_1_1", "CUSTOM_COOLER_V_MEAN")
    frame = frame[frame.time_s > SECOND_WINDOW]
    return {"time_s": frame.time_s - frame.time_s.iloc[0], "air_c": frame.TA_1_1_1, "sunshine_kw_m2": frame.SW_IN_1_1_1 / 1000, "cooler_v": frame.CUSTOM_COOLER_V_MEAN}


def models(c):
    y, x, t, sun = c["cooler_v"], c["air_c"], c["time_s"], c["sunshine_kw_m2"]
    late = lambda p: lag(sun, t, abs(p) * 1800)
    return y, {
        **usual(y, x, t, 1800),
        "sunshine": line(y, x, sun),
        HAND_BUILT: terms(y, lambda p: [x, late(p[0])], [1.0]),
        "late sunshine, and square": terms(y, lambda p: [x, x**2, late(p[0])], [1.0]),
    }
