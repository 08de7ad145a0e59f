"""How damp the air of London is over how warm it is, 40 days of late summer. Warm air could hold more water, and what it has of it goes with the day."""

from durations import HOUR
from models.cycles import waves_of_day
from models.fitting import line, scaled
from models.lags import behind, usual_and_shifts
from readers.supy import town

HAND_BUILT = "day, and cube"


def rows(content):
    return town(content, 5000, 960, air_degc="Tair", humidity_percent="RH")


def models(c):
    y, x, t = c["humidity_percent"], c["air_degc"], c["time_s"]
    u, w = scaled(x), scaled(t)
    return y, {
        **usual_and_shifts(y, x, t, 3 * HOUR),
        "cube": line(y, x, u**2, u**3),
        "drift, and its square": line(y, x, w, w**2),
        **behind(y, x, t, 20 * HOUR),
        **waves_of_day(y, x, t),
    }
