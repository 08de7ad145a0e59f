"""X-rays of the sun of short waves over those of longer ones, a flare. The plasma is hottest at the beginning, when little of it is there, and cools down; short waves need it hot."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag, moved
from readers.sunkit_instruments import two_detectors

HAND_BUILT = "slope that fades"


def rows(content):
    return two_detectors(content, "xrsb1_flux", "xrsa1_flux", ("long_uw_m2", "short_uw_m2"))


def models(c):
    y, x, t = c["short_uw_m2"], c["long_uw_m2"] / 50, c["time_s"]
    early = lambda p: moved(x, t, p * 100)
    rest = lambda p: lag(x, t, abs(p) * 100)
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "cube": line(y, x, x**2, x**3),
        "drift": line(y, x, t),
        "slope that drifts": line(y, x, t, x * t),
        "slope that drifts, and square": line(y, x, t, x * t, x**2),
        "slope that fades": terms(y, lambda p: [x, x * np.exp(-t / (abs(p[0]) * 1000))], [1.0]),
        "shift": terms(y, lambda p: [early(p[0])], [-1.0]),
        "square that is shifted": terms(y, lambda p: [early(p[0]), early(p[0]) ** 2], [-1.0]),
        "part that is left behind": terms(y, lambda p: [x, rest(p[0])], [3.0]),
        "square, and part that is left behind": terms(y, lambda p: [x, x**2, rest(p[0])], [3.0]),
        "rate": line(y, x, np.gradient(x)),
        "square, and rate": line(y, x, x**2, np.gradient(x)),
    }
