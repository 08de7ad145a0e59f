"""Probe of the electric field in a radio-frequency line over the power that is sent into it, six sweeps up and down.

It follows the root of the power, nearly, and is read two rows before it. A row counts as a second; the file has no clock.
"""

import numpy as np
from formats.text import csv
from models.fitting import line, terms
from models.lags import lag

HAND_BUILT = "root and power, shifted"


def rows(content):
    d = csv(content, sep="\t").dropna(subset=["NI9205_Power1", "NI9205_E2"])
    return {"row": np.arange(len(d)) * 1.0, "power_w": d.NI9205_Power1, "probe_v": d.NI9205_E2}


def models(c):
    y, x, t = c["probe_v"], c["power_w"], c["row"]
    root = np.sqrt(np.maximum(x, 0))
    return y, {
        "line": line(y, x),
        "cubic": line(y, x, x**2, x**3),
        "root": line(y, root),
        "root and power": line(y, root, x),
        "root, power and lag": terms(y, lambda p: [root, x, lag(root, t, abs(p[0]))], [5.0]),
        HAND_BUILT: terms(y, lambda p: [np.interp(t - p[0], t, root), np.interp(t - p[0], t, x)], [-1.0]),
        "root, power and drift": line(y, root, x, t),
    }
