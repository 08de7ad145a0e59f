"""Optical density of a well in which cells grow over that of the well beside it, a day. Next to nothing is missing."""

from fitting import line
from meters import plate
from recorders import usual_and_bends

HAND_BUILT = "line"


def rows(content):
    read = plate(content, "A1", "A2")
    return {"time_s": read["time_s"], "first_density": read["A1"], "second_density": read["A2"]}


def models(c):
    y, x, t = c["second_density"], c["first_density"], c["time_s"] / 3600
    return y, {**usual_and_bends(y, x, t, 1), "square, and drift": line(y, x, x**2, t), "slope that drifts": line(y, x, t, x * t)}
