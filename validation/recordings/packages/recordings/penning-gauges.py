"""Two cold-cathode gauges at two places of a vacuum line in which discharges set gas free, eleven bursts: one is not in proportion to the other. A row counts as a second; the file has no clock."""

import numpy as np
from formats.text import csv
from models.fitting import line, terms
from models.lags import lag

HAND_BUILT = "two lags and a power"


def rows(content):
    d = csv(content, sep="\t").dropna(subset=["NI9205_Penning1", "NI9205_Penning2"])
    return {"row": np.arange(len(d)) * 1.0, "gauge_2": d.NI9205_Penning2 * 1e6, "gauge_1": d.NI9205_Penning1 * 1e6}


def models(c):
    y, x, t = c["gauge_1"], c["gauge_2"], c["row"]

    def shifted(p):
        return [np.interp(t - p[0], t, x)]

    def lags(p):
        return [lag(x, t, abs(tau)) for tau in p]

    def bent(p):
        return [np.maximum(slow, 1e-9) ** p[-1] for slow in lags(p[:-1])]

    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "shift": terms(y, shifted, [1.0]),
        "lag": terms(y, lags, [3.0]),
        "two lags": terms(y, lags, [2.0, 30.0]),
        "lag and power": terms(y, bent, [3.0, 1.0]),
        HAND_BUILT: terms(y, bent, [2.0, 30.0, 1.0]),
        "lag, and gain that drifts": terms(y, lambda p: [*lags(p), lags(p)[0] * t / t[-1]], [3.0]),
        "two lags, and gain that drifts": terms(y, lambda p: [*lags(p), lags(p)[0] * t / t[-1]], [2.0, 30.0]),
    }
