"""Shear stress of two slabs of rock over how far a press has pushed, until they slide."""

import numpy as np
from models.bends import bends_with, corner
from models.fitting import line, scaled, terms
from readers.pylook import rock_press

HAND_BUILT = "soft step"


def rows(content):
    return rock_press(content, "shear_mpa", first=1459, last=9000, every=5)


def models(c):
    y, x, t = c["shear_mpa"], c["slip_um"], c["time_s"]
    u = scaled(x)
    above = lambda p: np.maximum(u - p, 0)
    return y, {
        **bends_with(y, x, drift=t),
        "saturation": terms(y, lambda p: [np.minimum(u, p[0])], [0.5]),
        "corner": corner(y, u, -0.5),
        "fourth power": line(y, u, u**2, u**3, u**4),
        "two corners": terms(y, lambda p: [u, above(p[0]), above(p[1])], [-0.9, 0.7]),
        "three corners": terms(y, lambda p: [u, above(p[0]), above(p[1]), above(p[2])], [-1.2, -0.5, 0.7]),
        "soft step": terms(y, lambda p: [np.tanh((u - p[0]) / p[1])], [0.0, 1.0]),
        "soft step, and line": terms(y, lambda p: [u, np.tanh((u - p[0]) / p[1])], [0.0, 1.0]),
    }
