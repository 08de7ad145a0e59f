"""A pulse of ultrasound as a hydrophone tells it over the pressure that a reference tells, 2 us, 500 rows each us. The hydrophone has a response of its own."""

import numpy as np
from formats.text import csv
from models.fitting import line, terms
from models.lags import lag, usual

HAND_BUILT = "line and two lags"


def rows(measured, reference):
    told, true = (csv(content, sep=r"\s+", comment="#", header=None).to_numpy(float) for content in (measured, reference))
    return {"time_s": told[:, 0], "reference_mpa": true[:, 1], "told": told[:, 1]}


def models(c):
    y, x, t = c["told"], c["reference_mpa"], c["time_s"]
    unit = 1e-8
    late = lambda p: lag(x, t, abs(p) * unit)
    rate = np.gradient(x, t)
    return y, {
        **usual(y, x, t, unit),
        "line and rate": line(y, x, rate * unit),
        "line and lag": terms(y, lambda p: [x, late(p[0])], [1.0]),
        "line, lag, and square": terms(y, lambda p: [x, x**2, late(p[0])], [1.0]),
        HAND_BUILT: terms(y, lambda p: [x, late(p[0]), late(p[1])], [1.0, 10.0]),
    }
