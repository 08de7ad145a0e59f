"""Ultrasonic response over the distance in metal; the model is the certified one of NIST."""

import numpy as np
from formats.nist import nist
from models.fitting import curve, line

HAND_BUILT = "exp(-b1 x) / (b2 + b3 x)"


def rows(content):
    return nist(content, ["ultrasonic_response", "distance"])


def models(c):
    y, x = c["ultrasonic_response"], c["distance"]
    decay = curve(y, lambda p: np.exp(-p[0] * x) / (p[1] + p[2] * x), [0.19, 0.0061, 0.0105])
    return y, {"line": line(y, x), HAND_BUILT: decay}
