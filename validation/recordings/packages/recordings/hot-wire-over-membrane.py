"""Volts of a hot wire over those of a membrane that hydrogen presses, while it comes through a wall for eight and a half hours. The wire tells a pressure by its logarithm."""

import numpy as np
from models.drifts import usual_shifts_and_drifts
from models.fitting import line, scaled, terms
from readers.shield_data import permeation

HAND_BUILT = "power, and drift"


def rows(content):
    return permeation(content, 30, "lower_v", "wire_v", lower=(1.5, 10.0))


def models(c):
    y, x, t = c["wire_v"], c["lower_v"], c["time_s"]
    u, w, above = scaled(x), scaled(t), lambda p: np.log(np.maximum(x - p, 1e-3))
    return y, {
        **usual_shifts_and_drifts(y, x, t, 600),
        "logarithm": line(y, np.log(x)),
        "logarithm, and line": line(y, np.log(x), x),
        "logarithm, and drift": line(y, np.log(x), w),
        "logarithm less a zero": terms(y, lambda p: [above(p[0])], [0.25]),
        "logarithm less a zero, and drift": terms(y, lambda p: [above(p[0]), w], [0.25]),
        "power": terms(y, lambda p: [x ** p[0]], [0.3]),
        "power, and drift": terms(y, lambda p: [x ** p[0], w], [0.3]),
        "square, cube, and drift": line(y, x, u**2, u**3, w),
    }
