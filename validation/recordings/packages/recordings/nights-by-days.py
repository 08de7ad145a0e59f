"""Least temperature of a day in a city by the sea over the greatest, four years. Nights follow the days before as well, and clouds keep them warm."""

import numpy as np
from durations import DAY, YEAR
from formats.text import dated
from models.cycles import tone
from models.fitting import line, terms
from models.lags import lag, late_models

HAND_BUILT = "line and lag, and root of the rain, late"


def rows(content):
    read = dated(content, "temp_max", "temp_min", "precipitation")
    return {"time_s": read.time_s, "warmest_degc": read.temp_max, "coldest_degc": read.temp_min, "rain_mm": read.precipitation}


def models(c):
    y, x, rain, t = c["coldest_degc"], c["warmest_degc"], c["rain_mm"], c["time_s"]
    wet, year = np.sqrt(rain), tone(t, YEAR)
    late = lambda p: lag(x, t, abs(p) * 10 * DAY)
    return y, {
        **late_models(y, x, t, 20 * DAY),
        "cube": line(y, x, x**2, x**3),
        "year": line(y, x, *year),
        "rain": line(y, x, rain),
        "root of the rain": line(y, x, wet),
        "slope by the root of the rain": line(y, x, wet, x * wet),
        "year, and square": line(y, x, *year, x**2),
        "year, and root of the rain": line(y, x, *year, wet),
        "line and lag, and rain": terms(y, lambda p: [x, late(p[0]), rain], [1.0]),
        "line and lag, and root of the rain": terms(y, lambda p: [x, late(p[0]), wet], [1.0]),
        "line and lag, and root of the rain, late": terms(y, lambda p: [x, late(p[0]), lag(wet, t, abs(p[1]) * DAY)], [1.0, 0.5]),
    }
