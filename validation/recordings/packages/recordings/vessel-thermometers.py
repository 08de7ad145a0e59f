"""Two thermometers of a cold crystal of a monochromator, a day, every second point. They agree; a lag takes a tenth of the small rest."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.spec2nexus import every_second_point

HAND_BUILT = "lag"


def rows(content):
    frame = every_second_point(content)
    return {"time_s": frame.time_s, "first_k": frame.HRMTemp3, "second_k": frame.HRMTemp4}


def models(c):
    y, x, t = c["second_k"], c["first_k"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x - 124.6, (x - 124.6) ** 2),
        "drift": line(y, x, t),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 1000, t, x)], [0.5]),
        HAND_BUILT: terms(y, lambda p: [lag(x, t, abs(p[0]) * 2000)], [0.3]),
        "line and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 2000)], [1.0]),
    }
