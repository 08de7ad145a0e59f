"""Temperature in the box of a counter beside that of the air outside, hourly, 110 days of a winter. The box follows late, and the sun shines on it."""

import numpy as np
from models.cycles import tone
from models.fitting import line, terms
from models.lags import lag
from readers.neptoon import muon_counter

HAND_BUILT = "lag, and hours of the day"


def rows(content):
    frame = muon_counter(content)
    return {"time_s": frame.time_s, "air_c": frame.outside, "box_c": frame.inside}


def models(c):
    y, x, t = c["box_c"], c["air_c"], c["time_s"]
    hours = [*tone(t, 86400), *tone(t, 43200)]
    return y, {
        "line": line(y, x),
        "drift": line(y, x, t),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 3600, t, x)], [1.0]),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 3600)], [1.0]),
        "hours of the day": line(y, x, *hours),
        HAND_BUILT: terms(y, lambda p: [lag(x, t, abs(p[0]) * 3600), *hours], [1.0]),
    }
