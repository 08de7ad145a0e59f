"""Absolute pressure of a logger under water in a well over that of the barometer beside it, 45 days of late summer, each hour. The water table falls."""

import numpy as np
from formats.clock import seconds
from models.fitting import line, terms
from models.lags import usual
from readers.gensor import wells

HAND_BUILT = "drift"


def rows(first, second, barometer):
    frame = wells(first, second, barometer)
    frame = frame[(frame.when >= "2021-08-19") & (frame.when < "2021-10-03")]
    return {"time_s": seconds(frame.when), "air_hpa": frame.pressure, "level_hpa": frame.pressure_2}


def models(c):
    y, x, t = c["level_hpa"], c["air_hpa"], c["time_s"]
    return y, {
        **usual(y, x, t, 3600),
        "drift, bent": line(y, x, t, t**2),
        "drift that fades": terms(y, lambda p: [x, np.exp(-t / (abs(p[0]) * 1e6))], [1.0]),
        "drift and square": line(y, x, x**2, t),
    }
