"""Zinc in the soil of a river bank over how far away the river is. Floods bring it, and seldom where the bank is high."""

import numpy as np
from models.drivers import of_drivers
from models.fitting import line, scaled, terms
from readers.scikit_gstat import river_bank_soil

HAND_BUILT = "cube, and height"


def rows(content):
    return river_bank_soil(content, distance="dist", height_m="elev", zinc_ppm="zinc")


def models(c):
    y, x, height = c["zinc_ppm"], c["distance"], c["height_m"]
    v, far = scaled(height), lambda p: np.exp(-x / abs(p))
    return y, {
        **of_drivers(y, x, height=height),
        "cube, and height": line(y, x, scaled(x) ** 2, scaled(x) ** 3, v),
        "root": line(y, np.sqrt(x)),
        "root, and height": line(y, np.sqrt(x), v),
        "root, and slope by height": line(y, np.sqrt(x), v, np.sqrt(x) * v),
        "fading": terms(y, lambda p: [far(p[0])], [0.2]),
        "fading, and height": terms(y, lambda p: [far(p[0]), v], [0.2]),
        "fading, and slope by height": terms(y, lambda p: [far(p[0]), v, far(p[0]) * v], [0.2]),
    }
