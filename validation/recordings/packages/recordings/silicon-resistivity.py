"""One silicon wafer measured on five days by each of five probing instruments: the certified analysis of variance finds no difference."""

import numpy as np
from formats.nist import nist
from models.fitting import line

HAND_BUILT = "constant"


def rows(content):
    found = nist(content, ["instrument", "resistivity"])
    instrument = found["instrument"].astype(int)
    return {"instrument": instrument, "day": 1 + np.arange(len(instrument)) % 5, "resistivity": found["resistivity"]}


def models(c):
    y = c["resistivity"]
    of = [(c["instrument"] == k) * 1.0 for k in range(2, 6)]
    return y, {HAND_BUILT: line(y), "instruments": line(y, *of), "day": line(y, c["day"])}
