"""Temperature of the box of a logger over that of the air, beside sunshine (as its sensor tells it, in mV), a town, seven weeks of summer, each 20 min."""

from models.fitting import line, terms
from models.lags import lag, usual
from readers.pypromice import tried_in_town

HAND_BUILT = "late sunshine"


def rows(content):
    frame = tried_in_town(content, "Asp_temp_L", "SWUpper", "LoggerTemp")
    return {"time_s": frame.time_s, "air_c": frame.Asp_temp_L, "sunshine_mv": frame.SWUpper / 100, "box_c": frame.LoggerTemp}


def models(c):
    y, x, t, sun = c["box_c"], c["air_c"], c["time_s"], c["sunshine_mv"]
    late = lambda p: lag(sun, t, abs(p) * 600)
    return y, {
        **usual(y, x, t, 600),
        "sunshine": line(y, x, sun),
        HAND_BUILT: terms(y, lambda p: [x, late(p[0])], [3.0]),
        "late sunshine, and square": terms(y, lambda p: [x, x**2, late(p[0])], [3.0]),
        "late sunshine, and late air": terms(y, lambda p: [lag(x, t, abs(p[1]) * 600), late(p[0])], [3.0, 1.0]),
    }
