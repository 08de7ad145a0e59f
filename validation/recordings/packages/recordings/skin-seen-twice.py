"""Light that comes back from one place of the skin over what comes back from another beside it, six wavelengths of 100 people."""

import numpy as np
from models.drivers import of_drivers
from models.fitting import line, scaled
from readers.iadpython import skin_twice

HAND_BUILT = "line"


def rows(content):
    return skin_twice(content, 3, 550, 661, 850, 1069, 1250, 1651)


def models(c):
    y, x, wavelength = c["second"], c["first"], c["nm"]
    v = scaled(wavelength)
    return y, {
        "as it is": lambda seen: x,
        "zero": lambda seen: x + np.mean((y - x)[seen]),
        **of_drivers(y, x, wavelength=wavelength),
        "logarithm of the wavelength": line(y, x, np.log(wavelength)),
        "number": line(y, x, c["run"]),
        "slope by number": line(y, x, v, scaled(c["run"]), scaled(c["run"]) * scaled(x)),
    }
