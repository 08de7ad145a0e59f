"""Relative humidity inside of the housing of a logger, twelve weeks of an arctic summer, a row an hour. Water gets in; warm walls give it off."""

from models.fitting import line, terms
from models.lags import lag
from readers.tsp import logger_housing

HAND_BUILT = "temperature, and bent drift"


def rows(content):
    frame = logger_housing(content)
    return {"time_s": frame.time_s, "inside_c": frame.temperature, "humidity_pct": frame.humidity}


def models(c):
    y, x, t = c["humidity_pct"], c["inside_c"], c["time_s"]
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "temperature": line(y, x),
        "temperature, and drift": line(y, x, t),
        HAND_BUILT: line(y, x, t, t**2),
        "late temperature, and drift": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 3600), t], [24.0]),
    }
