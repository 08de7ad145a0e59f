"""How far fourteen leaves open their pores for vapour over the carbon dioxide that they take up, 145 readings in a chamber, a run a leaf. Wide pores bring less and less."""

import numpy as np
from models.drivers import of_drivers
from models.fitting import line, terms
from readers.photorch import leaves

HAND_BUILT = "square"


def rows(content):
    return leaves(content)


def models(c):
    y, x, dry = c["conductance_mol"], c["uptake_umol"], c["deficit_kpa"]
    root = np.sqrt(dry)
    return y, {
        **of_drivers(y, x, dry=dry),
        "over root of dry": line(y, x / root),
        "line, and over root of dry": line(y, x, x / root),
        "square, and over root of dry": line(y, x, x**2, x / root),
        "soft corner": terms(y, lambda p: [np.logaddexp(0, (x - p[0]) / 3)], [5.0]),
        "a power": terms(y, lambda p: [np.clip(x + 3, 0, None) ** p[0]], [1.5]),
    }
