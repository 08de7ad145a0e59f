"""Temperature along a cable by scattered light, 98 m through warm and cold water, over the logarithm of its two lines' ratio. One line fades faster along the fibre, and the law is bent."""

import numpy as np
from models.fitting import line
from readers.dtscalibration import fibre

HAND_BUILT = "length, bent"


def rows(content):
    frame = fibre(content)
    return {"along_m": frame.along, "log_ratio": np.log(frame.stokes / frame.anti), "fibre_c": frame.degc}


def models(c):
    y, x, along = c["fibre_c"], c["log_ratio"], c["along_m"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "length": line(y, x, along),
        "length and its square": line(y, x, along, along**2),
        HAND_BUILT: line(y, x, along, x**2),
        "gain by length": line(y, x, along * x),
    }
