"""Shear stress of two slabs of rock over how far a press has drawn back, until it lets them go."""

import numpy as np
from models.bends import bends_with
from models.fitting import line, scaled, terms
from readers.pylook import rock_press

HAND_BUILT = "slack, and drift"


def rows(content):
    return rock_press(content, "shear_mpa", first=84620, last=85620, every=1)


def models(c):
    y, x, t = c["shear_mpa"], c["slip_um"], c["time_s"]
    u = scaled(x)
    held, soft = lambda p: np.maximum(u, p), lambda p, w: abs(w) * np.logaddexp(0, (u - p) / abs(w))
    return y, {
        **bends_with(y, x, drift=t),
        "fourth power": line(y, u, u**2, u**3, u**4),
        "slack": terms(y, lambda p: [held(p[0])], [-1.0]),
        "slack, and square": terms(y, lambda p: [held(p[0]), held(p[0]) ** 2], [-1.0]),
        "slack, and drift": terms(y, lambda p: [held(p[0]), t], [-1.0]),
        "slack, square, and drift": terms(y, lambda p: [held(p[0]), held(p[0]) ** 2, t], [-1.0]),
        "slack, and logarithm": terms(y, lambda p: [held(p[0]), np.log1p(t)], [-1.0]),
        "slack, and corner": terms(y, lambda p: [held(p[0]), held(p[1])], [-1.0, 0.5]),
        "soft slack": terms(y, lambda p: [soft(p[0], p[1])], [-1.0, 0.2]),
        "soft slack, and square": terms(y, lambda p: [soft(p[0], p[1]), soft(p[0], p[1]) ** 2], [-1.0, 0.2]),
    }
