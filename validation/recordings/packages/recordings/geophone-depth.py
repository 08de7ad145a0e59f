"""Thickness of a layer under a line of geophones in Alberta: flat, and then it falls away. Units are not stated in the package."""

import numpy as np
from models.fitting import line, terms
from readers.rdatasets import frame

HAND_BUILT = "hinge"


def rows(content):
    d = frame(content)
    return {"distance_m": d.distance, "thickness": d.thickness}


def models(c):
    y, x = c["thickness"], c["distance_m"]
    hinge = terms(y, lambda p: [x, np.maximum(x - p[0], 0)], [60.0])
    return y, {"line": line(y, x), HAND_BUILT: hinge, "cubic": line(y, x, x**2, x**3), "an S": terms(y, lambda p: [x, np.tanh((x - p[0]) / p[1])], [67.0, 6.0])}
