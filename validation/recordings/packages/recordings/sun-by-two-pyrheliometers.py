"""The sun by one pyrheliometer over that by another beside it, each minute of a day with clouds. Each has a logger of its own."""

from models.fitting import terms
from models.lags import late_shifts, moved
from readers.cpvlib import sunny_station

HAND_BUILT = "shift from there"


def rows(content):
    return sunny_station(content, 5, first_w_m2="Bn", second_w_m2="Bn_2")


def models(c):
    y, x, t = c["second_w_m2"], c["first_w_m2"], c["time_s"]
    both = lambda p: [moved(x, t, p[0] * 60), moved(x, t, p[1] * 60)]
    return y, {**late_shifts(y, x, t, 60, -0.9), "two shifts": terms(y, both, [-0.9, 0.5])}
