"""Height of a jet by its altimeter over that by satellites, from 700 s on. As it comes down the pilots set the altimeter to the pressure at the field."""

import numpy as np
from models.fitting import line, scaled, terms
from models.jumps import changed
from models.lags import lag, moved, usual_and_shifts
from readers.openap import flight

HAND_BUILT = "step at 3469 s, and shift"


def rows(content):
    return flight(content, 700, 2, satellites_ft="alt_gnss", altimeter_ft="alt")


def models(c):
    y, x, t = c["altimeter_ft"], c["satellites_ft"], c["time_s"]
    u, w, one, after = scaled(x), scaled(t), np.ones(len(x)), (t > 3469).astype(float)
    return y, {
        **usual_and_shifts(y, x, t, 1),
        "drift, and its square": line(y, x, w, w**2),
        "drift, and slope that drifts": line(y, x, w, u * w),
        "step": changed(y, t, [x], one),
        "slope that changes": changed(y, t, [x], x),
        "step, and square": changed(y, t, [x, u**2], one),
        "step, and drift": changed(y, t, [x, w], one),
        "step, drift, and its square": changed(y, t, [x, w, w**2], one),
        "step at 3469 s": line(y, x, after),
        "step at 3469 s, and square": line(y, x, u**2, after),
        "step at 3469 s, and drift": line(y, x, w, after),
        "step at 3469 s, and slope after it": line(y, x, after, u * after),
        "step at 3469 s, drift, and slope that drifts": line(y, x, w, u * w, after),
        "step at 3469 s, and shift": terms(y, lambda p: [moved(x, t, p[0]), after], [0.2]),
        "step at 3469 s, and lag": terms(y, lambda p: [lag(x, t, abs(p[0])), after], [0.2]),
        "step at 3469 s, shift, and drift": terms(y, lambda p: [moved(x, t, p[0]), w, after], [0.2]),
    }
