"""Carbon dioxide that a leaf of lettuce takes up over that inside of it, a run a curve, eleven curves at other lights and temperatures. It takes up no more than its light allows."""

import numpy as np
from models.drivers import of_drivers
from models.fitting import terms
from readers.phytorch_lib import gas_exchange

HAND_BUILT = "saturation, and slope of it by light"


def rows(content):
    return gas_exchange(content)


def models(c):
    y, x, light = c["uptake_umol"], c["inside_ppm"] / 500, c["light_umol"] / 1000
    most = lambda p: x / (x + abs(p))
    dark = lambda p: np.exp(-light / abs(p))
    return y, {
        **of_drivers(y, x, light=light),
        "saturation": terms(y, lambda p: [most(p[0])], [1.0]),
        "saturation, and light": terms(y, lambda p: [most(p[0]), light], [1.0]),
        "saturation, and slope of it by light": terms(y, lambda p: [most(p[0]), light, most(p[0]) * light], [1.0]),
        "saturation, and slope of it by light that saturates": terms(y, lambda p: [most(p[0]), dark(p[1]), most(p[0]) * dark(p[1])], [1.0, 0.5]),
    }
