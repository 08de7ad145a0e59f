"""What solar cells on one roof give over what those on another that faces the same way do, in the hours of ninety days."""

import numpy as np
from durations import DAY
from models.cycles import tone, usual_and_day
from models.fitting import line, scaled
from readers.citylearn import changed_at_best, roofs

HAND_BUILT = "line"


def rows(*contents):
    return roofs(*contents, begin=110, end=200, least=20)


def models(c):
    y, x, t = c["second_w_kw"], c["first_w_kw"], c["time_s"]
    u, w, day = scaled(x), scaled(t), [*tone(t, DAY), *tone(t, DAY / 2)]
    return y, {
        **usual_and_day(y, x, t),
        "cube": line(y, x, u**2, u**3),
        "slope by the day": line(y, x, *day, *(u * part for part in day)),
        "drift, and slope that drifts": line(y, x, w, u * w),
        **changed_at_best(y, x, t, np.arange(0.05, 0.96, 0.01)),
    }
