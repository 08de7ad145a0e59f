"""Thermometers at the two counting tubes of a neutron probe, 15 min, forty days. One tube is better wrapped: they warm at different speeds."""

import numpy as np
from models.cycles import tone
from models.fitting import line, terms
from models.lags import lag
from readers.neptoon import neutron_station

HAND_BUILT = "line and lag"


def rows(content):
    frame = neutron_station(content)
    return {"time_s": frame.time_s, "second_c": frame.N2T, "first_c": frame.N1T}


def models(c):
    y, x, t = c["second_c"], c["first_c"], c["time_s"]
    return y, {
        "line": line(y, x),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 1000, t, x)], [0.5]),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 3600)], [0.5]),
        HAND_BUILT: terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 3600)], [2.0]),
        "hours of the day": line(y, x, *tone(t, 86400), *tone(t, 43200)),
    }
