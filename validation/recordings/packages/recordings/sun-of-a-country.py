"""What the solar cells of a country gave, each half an hour of six days in May."""

import numpy as np
from durations import DAY
from models.cycles import tone
from models.fitting import line, scaled
from readers.sktime import solar_half_hours

HAND_BUILT = "four waves a day"


def rows(content):
    return solar_half_hours(content)


def models(c):
    y, t = c["solar"], c["time_s"]
    v, waves = scaled(t), [part for k in (1, 2, 3, 4) for part in tone(t, DAY / k)]
    return y, {
        "mean": line(y, np.zeros(len(t))),
        "drift": line(y, v),
        "one wave a day": line(y, *waves[:2]),
        "two waves a day": line(y, *waves[:4]),
        "three waves a day": line(y, *waves[:6]),
        "four waves a day": line(y, *waves),
        "two waves a day, and drift": line(y, *waves[:4], v),
        "two waves a day that grow": line(y, *waves[:4], v, *(v * part for part in waves[:4])),
    }
