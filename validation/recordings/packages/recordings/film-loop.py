"""Moment of a magnetic film on its substrate over the field, one loop of a SQUID magnetometer. The film has a loop and saturates, the substrate is diamagnetic."""

import numpy as np
from formats.clock import since_first
from formats.multivu import multivu
from models.fitting import terms
from readers.stoner import loop_models

HAND_BUILT = "two steps"


def rows(content):
    frame = multivu(content)
    return {"time_s": since_first(frame["Time Stamp (sec)"]), "field_koe": frame["Magnetic Field (Oe)"] / 1000, "moment_uemu": frame["Moment (emu)"] * 1e6}


def models(c):
    y, x = c["moment_uemu"], c["field_koe"]
    against = np.sign(np.gradient(x))
    step = lambda width, shift: np.tanh((x - shift * against) / abs(width))
    return y, {**loop_models(y, x, 0.2, 0.5), HAND_BUILT: terms(y, lambda p: [x, step(p[0], p[1]), step(p[2], p[3])], [0.1, 0.6, 0.5, 0.1])}
