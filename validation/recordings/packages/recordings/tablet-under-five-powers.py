"""Light that a tablet scatters by its bonds, twenty spectra under four powers of a laser, a run a spectrum, over the mean of five under the least power. More light in is more light out."""

import numpy as np
from models.drivers import of_drivers
from models.fitting import line, terms
from readers.ramanchada2 import powers

HAND_BUILT = "slope by power, its square, and its root"
MILLIWATTS = np.repeat([46, 106, 166, 227, 292], 5)


def rows(*contents):
    return powers(contents, MILLIWATTS, weakest=5, between=(250, 1750), every=10)


def models(c):
    y, x, power = c["strong_counts"], c["weak_counts"] / 1000, c["power_mw"] / 100
    return y, {
        **of_drivers(y, x, power=power),
        "product alone": line(y, x * power),
        "slope by power alone": line(y, x, x * power),
        "slope by power, and its square": line(y, x, power, x * power, power**2, x * power**2),
        "slope by power, its square, and its root": line(y, x, power, x * power, power**2, x * power**2, x * np.sqrt(power), np.sqrt(power)),
        "slope by a power of the power": terms(y, lambda p: [power ** p[0], x * power ** p[0]], [1.0]),
    }
