"""Temperature inside of a black globe over that of the air beside it, a weather station in a town, 15 days, each quarter of an hour. The sun heats the globe."""

import numpy as np
from formats.clock import seconds
from models.cycles import tone
from models.fitting import line, terms
from models.lags import lag, usual
from readers.metobs_toolkit import weather_station

HAND_BUILT = "line, lag, and day"


def rows(content):
    frame = weather_station(content, "vlinder02").iloc[::3].dropna(subset=["Temperatuur", "Globe Temperatuur"])
    at = seconds(frame.index)
    return {"time_s": at, "air_c": frame.Temperatuur, "globe_c": frame["Globe Temperatuur"]}


def models(c):
    y, x, t = c["globe_c"], c["air_c"], c["time_s"]
    day, half = tone(t, 86400), tone(t, 43200)
    return y, {
        **usual(y, x, t, 3600),
        "day": line(y, x, *day),
        "day and half a day": line(y, x, *day, *half),
        "shift, and day": terms(y, lambda p: [np.interp(t - p[0] * 3600, t, x), *day, *half], [-1.0]),
        "line and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 3600)], [2.0]),
        HAND_BUILT: terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 3600), *day, *half], [2.0]),
    }
