"""Water in a mug that cools: the mug takes heat first, then both lose it to the room."""

import numpy as np
from models.fitting import line, terms
from readers.rdatasets import frame

HAND_BUILT = "two exponentials"


def rows(content):
    d = frame(content)
    return {"time_min": d.time.astype(float), "water_temp": d.temp.astype(float)}


def models(c):
    y, t = c["water_temp"], c["time_min"]
    one = terms(y, lambda p: [np.exp(-t / abs(p[0]))], [50.0])
    two = terms(y, lambda p: [np.exp(-t / abs(p[0])), np.exp(-t / abs(p[1]))], [7.0, 100.0])
    return y, {"line": line(y, t), "one exponential": one, HAND_BUILT: two}
