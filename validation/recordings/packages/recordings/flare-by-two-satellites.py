"""X-rays of the sun as an old satellite told them over those of a new one, two hours with a great flare. Their clocks are more than a second apart, and one of them bends."""

import numpy as np
from models.fitting import line, terms
from models.lags import moved
from readers.sunkit_instruments import x_rays

HAND_BUILT = "square that is shifted"
SIXTIES = 946728000


def rows(old, new):
    old, new = x_rays(old, "b_flux"), x_rays(new, "xrsb2_flux")
    seconds = old["time"] - SIXTIES
    inside = seconds >= new["time"][0]
    first = seconds[inside][0]
    told = np.interp(seconds[inside], new["time"], new["xrsb2_flux"])
    return {"time_s": (seconds[inside] - first).round(3), "new_uw_m2": told, "old_uw_m2": old["b_flux"][inside]}


def models(c):
    y, x, t = c["old_uw_m2"], c["new_uw_m2"] / 400, c["time_s"]
    late = lambda p: moved(x, t, p * 5)
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "cube": line(y, x, x**2, x**3),
        "drift": line(y, x, t),
        "square, and drift": line(y, x, x**2, t),
        "slope that drifts": line(y, x, t, x * t),
        "shift": terms(y, lambda p: [late(p[0])], [-0.2]),
        "square that is shifted": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [-0.2]),
        "cube that is shifted": terms(y, lambda p: [late(p[0]) ** k for k in (1, 2, 3)], [-0.2]),
    }
