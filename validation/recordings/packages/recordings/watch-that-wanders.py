"""How far north somebody is who goes to and fro, by one watch over that by another on the same body, every third second."""

import numpy as np
from models.fitting import line, scaled, terms
from models.lags import lag, moved, usual_and_shifts
from readers.tracklib import two_tracks, watch

HAND_BUILT = "two shifts, and drift"


def rows(first, second):
    return two_tracks(watch(first), watch(second), "north", 3)


def models(c):
    y, x, t = c["second_m"], c["first_m"], c["time_s"]
    v = scaled(t)
    return y, {
        **usual_and_shifts(y, x, t, 10, twice=v**2),
        "drift, and its square": line(y, x, v, v**2),
        "drift, and slope that drifts": line(y, x, v, x * v),
        "drift, and square": line(y, x, x**2, v),
        "drift, and lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 10), v], [0.2]),
        "drift, and a wave": terms(y, lambda p: [x, v, np.sin(p[0] * v), np.cos(p[0] * v)], [2.0]),
        "logarithm": line(y, x, np.log1p(t / 60)),
        "two shifts, and drift": terms(y, lambda p: [moved(x, t, p[0] * 10), moved(x, t, p[1] * 10), v], [0.5, -0.5]),
    }
