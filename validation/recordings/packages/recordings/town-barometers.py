"""Pressure at a weather station over that at another of the same town, 15 days, each quarter of an hour. They agree but for a small wave by day."""

from models.cycles import tone
from models.fitting import line
from models.lags import usual
from readers.metobs_toolkit import station_pair

HAND_BUILT = "day"


def rows(content):
    at, first, second = station_pair(content, "vlinder07", "vlinder08", "Luchtdruk")
    return {"time_s": at, "first_hpa": first / 100, "second_hpa": second / 100}


def models(c):
    y, x, t = c["second_hpa"], c["first_hpa"], c["time_s"]
    return y, {
        **usual(y, x, t, 3600),
        HAND_BUILT: line(y, x, *tone(t, 86400)),
        "day, and drift": line(y, x, *tone(t, 86400), t),
    }
