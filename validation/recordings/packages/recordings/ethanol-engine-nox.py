"""Nitrogen oxides of an ethanol engine over equivalence ratio: a peak, and compression on the lean side of it."""

import numpy as np
from models.fitting import line, terms
from readers.rdatasets import frame

HAND_BUILT = "bell, and compression on the lean side"


def rows(content):
    d = frame(content)
    return {"equivalence": d.E, "compression": d.C.astype(float), "nox": d.NOx}


def models(c):
    y, e, compression = c["nox"], c["equivalence"], c["compression"]

    def bell(centre, width):
        return np.exp(-(((e - centre) / width) ** 2))

    def both(p):
        return [bell(p[0], p[1]), compression * bell(p[2], p[1])]

    return y, {"line": line(y, e), "bell": terms(y, lambda p: [bell(*p)], [0.9, 0.15]), HAND_BUILT: terms(y, both, [0.9, 0.15, 0.8])}
