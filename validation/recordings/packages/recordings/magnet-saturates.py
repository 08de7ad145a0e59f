"""Moment of a magnetic sample over the field, one loop of a vibrating-sample magnetometer, a row a second. It saturates, and has next to no loop."""

import numpy as np
from formats.clock import since_first
from formats.multivu import multivu
from models.fitting import line, terms
from readers.stoner import loop_models

HAND_BUILT = "two widths"


def rows(content):
    frame = multivu(content)
    return {"time_s": since_first(frame["Time Stamp (sec)"]), "field_koe": frame["Magnetic Field (Oe)"] / 1000, "moment_emu": frame["Moment (emu)"]}


def models(c):
    y, x = c["moment_emu"], c["field_koe"]
    both = lambda p: [x, np.tanh(x / abs(p[0])), np.arctan(x / abs(p[1]))]
    return y, {**loop_models(y, x, 1.0, 0.01), "arc tangent": terms(y, lambda p: [x, np.arctan(x / abs(p[0]))], [1.0]), HAND_BUILT: terms(y, both, [1.0, 2.0]), "square": line(y, x, x**2)}
