"""Thermometer on one hub, with 8 bits, over a thermometer on another hub, with 16 bits, which are warmed and cool together, means of a tenth of a second. One is behind the other."""

from formats.rows import means
from models.lags import usual_and_lags
from readers.biosignalsnotebooks import hubs, seconds_at

HAND_BUILT = "lag, and square"


def rows(content):
    coarse, fine = (means(values, 100) for values in hubs(content).values())
    return {"time_s": seconds_at(fine, 10), "fine_count": fine, "coarse_count": coarse}


def models(c):
    return c["coarse_count"], usual_and_lags(c["coarse_count"], c["fine_count"], c["time_s"], 2)
