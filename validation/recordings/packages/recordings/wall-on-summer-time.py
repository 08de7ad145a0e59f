"""Warmth at the north wall of a house over that at an airport 12 km away, each half hour of three weeks after clocks were put forward. The table of the airport was, and the logger of the house was not."""

from counters import DAY, walls
from fitting import line, moved, terms, tone, usual

HAND_BUILT = "shift, and day"


def rows(content):
    return walls(content, "2016-03-28", "2016-04-18", 3)


def models(c):
    y, x, t = c["wall_degc"], c["airport_degc"], c["time_s"]
    day = [*tone(t, DAY), *tone(t, DAY / 2)]
    at = lambda p: moved(x, t, p[0] * 3600)
    return y, {
        **usual(y, x, t, 3600),
        "shift ahead": terms(y, lambda p: [at(p)], [-0.5]),
        "day": line(y, x, *day),
        "day, and square": line(y, x, x**2, *day),
        "day, and drift": line(y, x, t, *day),
        "shift, and square": terms(y, lambda p: [at(p), at(p) ** 2], [-0.5]),
        "shift, and day": terms(y, lambda p: [at(p), *day], [-0.5]),
        "shift, day, and slope by it": terms(y, lambda p: [at(p), *day, *(at(p) * k for k in day[:2])], [-0.5]),
    }
