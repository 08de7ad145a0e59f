"""Reads files of the package spectrapepper, and holds models that its recordings share."""

import numpy as np
from formats.text import matrix
from models.drivers import of_drivers
from models.fitting import line, scaled, terms


def films(content, first, second):
    """Light that two films scatter, beside its shift in 1/cm, which is the first line; a line a film, counted from 0."""
    table = matrix(content)
    return {"shift_1_cm": table[0], "first": table[1 + first], "second": table[1 + second]}


def film_models(c):
    """Models of the light of one film over that of another."""
    y, x, place = c["second"], c["first"], c["shift_1_cm"]
    u, v = scaled(x), scaled(place)
    return y, {
        **of_drivers(y, x, place=place),
        "gain by place": line(y, x, v * x),
        "square, place, bent": line(y, x, u**2, v, v**2),
        "cube, and place": line(y, x, u**2, u**3, v),
        "logarithm": line(y, x, np.log(x)),
        "power": terms(y, lambda p: [x ** p[0]], [0.9]),
        "moved": terms(y, lambda p: [np.interp(place - p[0], place, x)], [0.1]),
        "moved, and place": terms(y, lambda p: [np.interp(place - p[0], place, x), v], [0.1]),
    }
