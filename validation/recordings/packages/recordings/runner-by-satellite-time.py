"""How far east somebody is who goes about, by a receiver that tells the time of the satellites over that by a watch that tells the time of the day, every third second."""

import numpy as np
from models.fitting import line, scaled, terms
from models.lags import late_shifts, moved
from readers.tracklib import receiver, two_tracks, watch

HAND_BUILT = "shift, and logarithm"


def rows(first, second):
    return two_tracks(watch(first), receiver(second), "east", 3)


def models(c):
    y, x, t = c["second_m"], c["first_m"], c["time_s"]
    at = lambda p: moved(x, t, p * 10)
    return y, {
        **late_shifts(y, x, t, 10, 1.9),
        "shift, and logarithm": terms(y, lambda p: [at(p[0]), np.log1p(t / 60)], [1.9]),
        "two shifts": terms(y, lambda p: [at(p[0]), at(p[1])], [1.9, 1.0]),
        "drift, and its square": line(y, x, scaled(t), scaled(t) ** 2),
    }
