"""The thermometer by which a cryostat is controlled over that at its sample, from 2 K to 25 K and back in an hour and a half. Heat is not at both at once: the first is a few seconds behind."""

import numpy as np
from models.fitting import terms
from models.lags import lag, usual
from readers.polartools import some_scans

HAND_BUILT = "shift, and drift"


def rows(content):
    frame = some_scans(content, 227, 228)
    return {"time_s": frame.time_s, "sample_k": frame.SampTemp, "control_k": frame.ControlTemp}


def models(c):
    y, x, t = c["control_k"], c["sample_k"], c["time_s"]
    at = lambda p: np.interp(t - p * 10, t, x)
    late = lambda p: lag(x, t, abs(p) * 10)
    return y, {
        **usual(y, x, t, 10),
        "shift, and square": terms(y, lambda p: [at(p[0]), at(p[0]) ** 2], [0.5]),
        HAND_BUILT: terms(y, lambda p: [at(p[0]), t], [0.5]),
        "bent lag": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [0.5]),
        "lag, and drift": terms(y, lambda p: [late(p[0]), t], [0.5]),
    }
