"""Two probes of the electric field in one line, at two places, six sweeps of the power in a travelling wave: one is the other times a gain. A row counts as a second; the file has no clock."""

import numpy as np
from formats.text import csv
from models.fitting import line, terms
from models.lags import lag

HAND_BUILT = "square"


def rows(content):
    d = csv(content, sep="\t").dropna(subset=["NI9205_E2", "NI9205_E5"])
    return {"row": np.arange(len(d)) * 1.0, "probe_2_v": d.NI9205_E2, "probe_5_v": d.NI9205_E5}


def models(c):
    y, x, t = c["probe_5_v"], c["probe_2_v"], c["row"]
    return y, {"line": line(y, x), HAND_BUILT: line(y, x, x**2), "cubic": line(y, x, x**2, x**3), "drift": line(y, x, t), "lag": terms(y, lambda p: [lag(x, t, abs(p[0]))], [1.0])}
