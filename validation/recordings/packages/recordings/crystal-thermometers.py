"""Two thermometers at a crystal of a monochromator, a day, every second point: one follows the other late."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.spec2nexus import every_second_point

HAND_BUILT = "line and lag"


def rows(content):
    frame = every_second_point(content)
    return {"time_s": frame.time_s, "near_k": frame.HRMTemp6, "far_k": frame.HRMTemp5}


def models(c):
    y, x, t = c["far_k"], c["near_k"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x - 296.9, (x - 296.9) ** 2),
        "drift": line(y, x, t),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 1000, t, x)], [0.5]),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 1000)], [0.5]),
        HAND_BUILT: terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 2000)], [2.0]),
    }
