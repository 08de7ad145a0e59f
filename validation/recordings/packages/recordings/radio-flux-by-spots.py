"""Radio waves of the sun over the number of its spots, means of a rotation, 68 years. The count of spots drifts, and the rotation before counts as well."""

import numpy as np
from durations import YEAR
from models.cycles import tone
from models.fitting import line, terms
from models.jumps import soft_step
from models.lags import lag
from readers.spaceweather import sun_by_rotation

HAND_BUILT = "spots, what they leave, and drift"


def rows(content):
    read = sun_by_rotation(content)
    return {"time_s": read.time_s, "spots": read.spots, "flux_sfu": read.flux_sfu}


def models(c):
    y, x, t, years = c["flux_sfu"], c["spots"] / 100, c["time_s"], c["time_s"] / YEAR
    left = lambda p: lag(x, t, abs(p) * YEAR)
    after = lambda p: soft_step(years, p * 10, 0.05)
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "cube": line(y, x, x**2, x**3),
        "root": line(y, x, np.sqrt(x)),
        "drift": line(y, x, years),
        "slope that drifts": line(y, x, years, x * years),
        "cube, and drift": line(y, x, x**2, x**3, years),
        "year": line(y, x, *tone(t, YEAR)),
        "step": terms(y, lambda p: [x, after(p[0])], [3.0]),
        "drift, and step": terms(y, lambda p: [x, years, after(p[0])], [6.3]),
        "lag": terms(y, lambda p: [left(p[0])], [0.1]),
        "spots, and what they leave": terms(y, lambda p: [x, left(p[0])], [1.0]),
        "spots, what they leave, and drift": terms(y, lambda p: [x, left(p[0]), years], [1.0]),
        "cube, and what they leave": terms(y, lambda p: [x, x**2, x**3, left(p[0])], [1.0]),
    }
