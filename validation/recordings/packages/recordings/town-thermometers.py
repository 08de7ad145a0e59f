"""Temperature at a weather station over that at another of the same town, 15 days, each quarter of an hour. Where there is more stone, a part of the warmth is late."""

from models.cycles import tone
from models.fitting import line, terms
from models.lags import lag, usual
from readers.metobs_toolkit import station_pair

HAND_BUILT = "line and lag"


def rows(content):
    at, first, second = station_pair(content, "vlinder07", "vlinder08", "Temperatuur")
    return {"time_s": at, "first_c": first, "second_c": second}


def models(c):
    y, x, t = c["second_c"], c["first_c"], c["time_s"]
    return y, {
        **usual(y, x, t, 3600),
        "day": line(y, x, *tone(t, 86400)),
        "day, and half a day": line(y, x, *tone(t, 86400), *tone(t, 43200)),
        HAND_BUILT: terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 3600)], [2.0]),
    }
