"""Logarithm of the ratio of two lines of scattered light along a cable, seen from its far end beside its near end, 98 m through warm and cold water. One line fades faster along the fibre."""

import numpy as np
from models.fitting import line
from readers.dtscalibration import fibre

HAND_BUILT = "length"


def rows(content):
    frame = fibre(content)
    forward, backward = np.log(frame.stokes / frame.anti), np.log(frame.back_stokes / frame.back_anti)
    return {"along_m": frame.along, "forward": forward, "backward": backward}


def models(c):
    y, x, along = c["backward"], c["forward"], c["along_m"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        HAND_BUILT: line(y, x, along),
        "length and its square": line(y, x, along, along**2),
        "length, and square": line(y, x, along, x**2),
        "gain by length": line(y, x, along * x),
    }
