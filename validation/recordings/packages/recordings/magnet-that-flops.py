"""Moment of a crystal at 2.5 K over its field, up to 7 T. Its magnets lie against each other, and turn across the field at about 2 T."""

import numpy as np
from models.bends import bends
from models.fitting import line, terms
from models.jumps import soft_step
from readers.ppms_toolkit import moments

HAND_BUILT = "another line after the turn"


def rows(content):
    frame = moments(content, 20)
    return {"field_t": frame["Magnetic Field (Oe)"] / 1e4, "moment_memu": frame["Moment (emu)"] * 1000}


def models(c):
    y, x = c["moment_memu"], c["field_t"]
    after = lambda p: soft_step(x, p[0], abs(p[1]) + 0.01)
    return y, {
        **bends(y, x),
        "ninth power": line(y, *((x / 7) ** np.arange(1, 10)[:, None])),
        "turn": terms(y, lambda p: [x, after(p)], [2.2, 0.2]),
        "another line after the turn": terms(y, lambda p: [x, after(p), x * after(p)], [2.2, 0.2]),
    }
