"""Counts of indium of mass 115 over those of mass 113 while a solar cell is worn off by ions. Of 1000 atoms 957 are of the first, more than the counter takes."""

import numpy as np
from models.bends import bends_with
from models.drifts import usual_and_drifts
from models.fitting import line, terms
from readers.grapa import sputtered_ions

HAND_BUILT = "counter that is full"


def rows(content):
    second, light, heavy = sputtered_ions(content, "", "^113In+", "In+")
    return {"time_s": second, "light_counts": light, "heavy_counts": heavy}


def models(c):
    y, x, t = c["heavy_counts"], c["light_counts"], c["time_s"]
    return y, {
        **bends_with(y, x),
        **usual_and_drifts(y, x, t),
        "square, and drift": line(y, x, x**2, t),
        "counter that is dead after each": terms(y, lambda p: [x / (1 + abs(p[0]) * x / 1e4)], [1.0]),
        "counter that is full": terms(y, lambda p: [1 - np.exp(-x * abs(p[0]) / 1000)], [1.0]),
        "counter that is full, and drift": terms(y, lambda p: [1 - np.exp(-x * abs(p[0]) / 1000), t], [1.0]),
    }
