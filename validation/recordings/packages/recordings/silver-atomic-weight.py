"""Atomic weight of one silver sample by two mass spectrometers, 24 times each: they differ by 0.16 ppm. In ppm above 107.868.

No row of an instrument that is left out tells its difference, so the constant is the model.
"""

import numpy as np
from formats.nist import nist
from models.fitting import line

HAND_BUILT = "constant"


def rows(content):
    found = nist(content, ["instrument", "weight"])
    instrument = found["instrument"].astype(int)
    return {"instrument": instrument, "analysis": 1 + np.arange(len(instrument)) % 24, "excess_ppm": (found["weight"] - 107.868) / 107.868 * 1e6}


def models(c):
    y = c["excess_ppm"]
    return y, {HAND_BUILT: line(y), "two instruments": line(y, c["instrument"])}
