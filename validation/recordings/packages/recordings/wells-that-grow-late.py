"""Optical density of a well in which cells grow over that of one in which they grow at once, a day. They begin late and grow more slowly, and end lower."""

from formats.plate_reader import densities
from models.fitting import line, terms
from models.lags import lag, moved, usual_and_lags

HAND_BUILT = "lag, and square"


def rows(content):
    read = densities(content, "A3", "C3")
    return {"time_s": read["time_s"], "early_density": read["A3"], "late_density": read["C3"]}


def models(c):
    y, x, t = c["late_density"], c["early_density"], c["time_s"] / 3600
    late = lambda p: moved(x, t, p)
    return y, {
        **usual_and_lags(y, x, t, 5),
        "slope that drifts": line(y, x, t, x * t),
        "square that is shifted": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [2.0]),
        "lag, and slope that drifts": terms(y, lambda p: [lag(x, t, abs(p[0])), t, t * lag(x, t, abs(p[0]))], [3.0]),
    }
