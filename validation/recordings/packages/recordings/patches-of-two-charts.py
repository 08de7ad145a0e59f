"""Light that 24 patches of a chart of colours send back over what those of another chart do, 36 wavelengths."""

import numpy as np
from models.drivers import of_drivers
from models.fitting import line, scaled
from readers.colour_science import two_charts

HAND_BUILT = "line"


def rows(*contents):
    return two_charts(*contents)


def models(c):
    y, x, wavelength, run = c["second"], c["first"], c["nm"], c["run"]
    return y, {
        "as it is": lambda seen: x,
        "zero": lambda seen: x + np.mean((y - x)[seen]),
        **of_drivers(y, x, wavelength=wavelength),
        "zero of each patch": line(y, x, *(run == k for k in np.unique(run)[1:])),
        "slope of each patch": line(y, x, *(x * (run == k) for k in np.unique(run)[1:])),
        "number": line(y, x, scaled(run)),
        "logarithm": line(y, x, np.log(x)),
    }
