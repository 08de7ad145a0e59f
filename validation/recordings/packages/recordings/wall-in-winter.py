"""Warmth at the north wall of a house over that at an airport 12 km away, each half hour of four weeks in winter. The sun stands low and is behind the house."""

from counters import DAY, walls
from fitting import line, moved, terms, tone, usual

HAND_BUILT = "day"


def rows(content):
    return walls(content, "2016-01-12", "2016-02-09", 3)


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
