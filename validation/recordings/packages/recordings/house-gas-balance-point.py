"""Gas that a house burns over the temperature outside: above a balance point it is not heated."""

import numpy as np
from models.fitting import line, terms
from readers.rdatasets import frame

HAND_BUILT = "hinge"


def rows(content):
    d = frame(content)
    return {"outside_c": (d.temp.astype(float) - 32) / 1.8, "therms_per_day": d.thermsPerDay}


def models(c):
    y, outside = c["therms_per_day"], c["outside_c"]
    return y, {"line": line(y, outside), HAND_BUILT: terms(y, lambda p: [np.minimum(outside - p[0], 0)], [15.0])}
