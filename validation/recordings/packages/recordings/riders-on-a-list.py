"""Bicycles lent each hour to those who are on a list over those lent to others, 83 days of spring in Washington. Who is on a list rides to work."""

from durations import HOUR
from models.cycles import waves_of_day
from models.fitting import line, scaled
from models.lags import usual_and_shifts
from readers.islp import riders

HAND_BUILT = "day, and cube"


def rows(content):
    return riders(content, 2000, 2000)


def models(c):
    y, x, t = c["registered"], c["casual"], c["time_s"]
    u = scaled(x)
    return y, {
        **usual_and_shifts(y, x, t, HOUR),
        "cube": line(y, x, u**2, u**3),
        **waves_of_day(y, x, t),
    }
