"""Copper in the soil of a river bank over zinc, by a laboratory. Both came with the floods."""

import numpy as np
from models.drivers import of_drivers
from models.fitting import line
from readers.scikit_gstat import river_bank_soil

HAND_BUILT = "line"


def rows(content):
    return river_bank_soil(content, distance="dist", zinc_ppm="zinc", copper_ppm="copper")


def models(c):
    y, x = c["copper_ppm"], c["zinc_ppm"]
    return y, {**of_drivers(y, x, distance=c["distance"]), "logarithm": line(y, np.log(x)), "line, and logarithm": line(y, x, np.log(x))}
