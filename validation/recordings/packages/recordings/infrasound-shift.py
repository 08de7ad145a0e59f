"""Infrasound of a blast at one sensor over that at another of a small array, each told over its own scatter. A row counts as a second; the sound is there 22 rows apart."""

import numpy as np
from formats.text import csv
from models.fitting import terms
from models.lags import usual

HAND_BUILT = "shift"


def rows(content):
    frame = csv(content)
    return {"time_s": np.arange(len(frame), dtype=float), "second": frame.sensor2, "third": frame.sensor3}


def models(c):
    y, x, t = c["third"], c["second"], c["time_s"]
    at = lambda p: np.interp(t - p, t, x)
    return y, {
        **usual(y, x, t, 20),
        HAND_BUILT: terms(y, lambda p: [at(p[0])], [-20.0]),
        "shift, and square": terms(y, lambda p: [at(p[0]), at(p[0]) ** 2], [-20.0]),
        "shift, and drift": terms(y, lambda p: [at(p[0]), t], [-20.0]),
    }
