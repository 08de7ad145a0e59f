"""Optical density of a well in which cells grow over that of the well beside it, a day. Next to nothing is missing."""

from formats.plate_reader import densities
from models.bends import usual_and_bends
from models.fitting import line

HAND_BUILT = "line"


def rows(content):
    read = densities(content, "A1", "A2")
    return {"time_s": read["time_s"], "first_density": read["A1"], "second_density": read["A2"]}


def models(c):
    y, x, t = c["second_density"], c["first_density"], c["time_s"] / 3600
    return y, {**usual_and_bends(y, x, t, 1), "square, and drift": line(y, x, x**2, t), "slope that drifts": line(y, x, t, x * t)}
