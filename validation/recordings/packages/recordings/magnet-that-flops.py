"""Moment of a crystal at 2.5 K over its field, up to 7 T. Its magnets lie against each other, and turn across the field at about 2 T."""

import numpy as np
from counters import moments
from fitting import line, terms
from rigs import bends
from sensors import switched

HAND_BUILT = "another line after the turn"


def rows(content):
    frame = moments(content, 20)
    return {"field_t": frame["Magnetic Field (Oe)"] / 1e4, "moment_memu": frame["Moment (emu)"] * 1000}


def models(c):
    y, x = c["moment_memu"], c["field_t"]
    after = lambda p: switched(x, p[0], abs(p[1]) + 0.01)
    return y, {
        **bends(y, x),
        "ninth power": line(y, *((x / 7) ** np.arange(1, 10)[:, None])),
        "turn": terms(y, lambda p: [x, after(p)], [2.2, 0.2]),
        "another line after the turn": terms(y, lambda p: [x, after(p), x * after(p)], [2.2, 0.2]),
    }
