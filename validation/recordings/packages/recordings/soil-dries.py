"""Moisture of sandy soil at 5 cm through ten weeks of a dry summer, a row an hour. It dries, fast first and slowly later."""

import numpy as np
from models.cycles import tone
from models.fitting import line, terms
from readers.ismn import moisture

HAND_BUILT = "logarithm"
DAY = 86400.0


def rows(content):
    frame = moisture(content, "2016-07-05", "2016-09-13 20:00")
    return {"time_s": frame.time_s, "moisture": frame.moisture}


def models(c):
    y, t = c["moisture"], c["time_s"]
    fades = lambda p: np.exp(-t / (abs(p) * DAY + 600))
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "exponential": terms(y, lambda p: [fades(p[0])], [10.0]),
        "exponential, and drift": terms(y, lambda p: [fades(p[0]), t], [10.0]),
        "exponential, and day": terms(y, lambda p: [fades(p[0]), *tone(t, DAY)], [10.0]),
        HAND_BUILT: terms(y, lambda p: [np.log1p(t / (abs(p[0]) * DAY + 600))], [1.0]),
        "two exponentials": terms(y, lambda p: [fades(p[0]), fades(p[1])], [3.0, 30.0]),
    }
