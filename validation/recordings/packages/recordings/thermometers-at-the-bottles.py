"""Water by one thermometer of a probe over that by the other where bottles were closed in the Baltic, twelve casts."""

import numpy as np
from models.drivers import of_drivers
from models.fitting import line
from readers.pycnv import bottles

HAND_BUILT = "cast"


def rows(*contents):
    return bottles(*contents, dbar=0, first_degc=3, second_degc=4)


def models(c):
    y, x = c["second_degc"], c["first_degc"]
    return y, {"as it is": lambda seen: x, "zero": lambda seen: x + np.mean((y - x)[seen]), **of_drivers(y, x, depth=c["dbar"]), "cast": line(y, x, c["run"])}
