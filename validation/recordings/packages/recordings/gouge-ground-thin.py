"""How far the layer between two slabs of rock is closed over how far they have slid, at one speed."""

import numpy as np
from models.bends import bends_with
from models.fitting import line, scaled, terms
from readers.pylook import rock_press

HAND_BUILT = "logarithm"


def rows(content):
    return rock_press(content, "layer_um", first=9500, last=18500, every=5)


def models(c):
    y, x, t = c["layer_um"], c["slip_um"], c["time_s"]
    u = scaled(x)
    fades = lambda p: np.exp(-t / (abs(p) * 100 + 1))
    return y, {
        **bends_with(y, x),
        "fourth power": line(y, u, u**2, u**3, u**4),
        "drift": line(y, u, t),
        "what fades": terms(y, lambda p: [u, fades(p[0])], [3.0]),
        "what fades twice": terms(y, lambda p: [u, fades(p[0]), fades(p[1])], [0.3, 3.0]),
        "logarithm": line(y, u, np.log1p(t / 10)),
        "logarithm from a time": terms(y, lambda p: [u, np.log1p(t / (abs(p[0]) + 0.1))], [10.0]),
        "logarithm, and square": line(y, u, u**2, np.log1p(t / 10)),
    }
