"""Temperature in the box of a neutron probe over that of the air outside, 15 min, forty days. The box follows late, and the sun shines on it."""

import numpy as np
from models.cycles import tone
from models.fitting import line, terms
from models.lags import lag
from readers.neptoon import neutron_station

HAND_BUILT = "lag, and hours of the day"


def rows(content):
    frame = neutron_station(content)
    return {"time_s": frame.time_s, "air_c": frame.TCS, "box_c": frame.T1}


def models(c):
    y, x, t = c["box_c"], c["air_c"], c["time_s"]
    hours = [*tone(t, 86400), *tone(t, 43200)]
    return y, {
        "line": line(y, x),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 1000, t, x)], [1.0]),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 3600)], [1.0]),
        "two lags": terms(y, lambda p: [lag(x, t, abs(q) * 3600) for q in p], [1.0, 10.0]),
        "hours of the day": line(y, x, *hours),
        HAND_BUILT: terms(y, lambda p: [lag(x, t, abs(p[0]) * 3600), *hours], [1.0]),
    }
