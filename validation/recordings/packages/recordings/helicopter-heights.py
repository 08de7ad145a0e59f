"""Height of a helicopter by satellites over that by its barometer. The one by satellites comes late."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.traffic import flight

HAND_BUILT = "lag, and drift"


def rows(content):
    frame = flight(content).dropna(subset=["altitude", "geoaltitude"])
    frame = frame[~frame.onground.astype(bool)]
    return {"time_s": frame.time_s, "barometer_ft": frame.altitude, "satellites_ft": frame.geoaltitude}


def models(c):
    y, x, t = c["satellites_ft"], c["barometer_ft"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 5, t, x)], [0.5]),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 5)], [0.5]),
        "line and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 5)], [1.0]),
        HAND_BUILT: terms(y, lambda p: [lag(x, t, abs(p[0]) * 5), t], [1.0]),
    }
