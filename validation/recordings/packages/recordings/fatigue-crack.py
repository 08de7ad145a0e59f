"""Length of a crack over cycles of load, one specimen a run: the longer it is the faster it grows (Paris), and specimens differ."""

import numpy as np
from models.fitting import curve, line
from readers.rdatasets import frame

HAND_BUILT = "Paris, one law for all"


def rows(content):
    d = frame(content)
    d = d.assign(Path=d.Path.astype(int)).sort_values(["Path", "cycles"], kind="stable")
    return {"run": d.Path, "cycles_m": d.cycles, "crack_in": d.relLength * 0.9}


def models(c):
    y, n = c["crack_in"], c["cycles_m"]
    paris = curve(y, lambda p: np.maximum(0.9 ** -p[0] - p[1] * n, 1e-2) ** (-1 / p[0]), [1.0, 4.0])
    return y, {"line": line(y, n), "square": line(y, n, n * n), HAND_BUILT: paris}
