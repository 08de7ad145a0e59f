"""Counts of gallium of mass 69 over those of mass 71 while a solar cell is worn off by ions. Both are of one element, 60 parts to 40."""

from models.bends import bends_with
from models.drifts import usual_and_drifts
from models.fitting import line
from readers.grapa import sputtered_ions

HAND_BUILT = "line"


def rows(content):
    second, light, heavy = sputtered_ions(content, "", "Ga+", "^71Ga+")
    return {"time_s": second, "heavy_counts": heavy, "light_counts": light}


def models(c):
    y, x, t = c["light_counts"], c["heavy_counts"], c["time_s"]
    return y, {"60 to 40": lambda seen: x * 60.1 / 39.9, **bends_with(y, x), **usual_and_drifts(y, x, t), "square, and drift": line(y, x, x**2, t)}
