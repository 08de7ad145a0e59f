"""Vertical speed that an aircraft sends, beside the change of its height over 20 s, in a flight that calibrates radio beacons. Height and speed come in messages of their own; the height is the older one."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.traffic import flight

HAND_BUILT = "shift"


def rows(content):
    frame = flight(content).dropna(subset=["altitude", "vertical_rate"])
    t, height = frame.time_s.to_numpy(), frame.altitude.to_numpy(float)
    climb = (np.interp(t + 10, t, height) - np.interp(t - 10, t, height)) * 3
    return {"time_s": t, "by_height_ft_min": climb, "vertical_ft_min": frame.vertical_rate}


def models(c):
    y, x, t = c["vertical_ft_min"], c["by_height_ft_min"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        HAND_BUILT: terms(y, lambda p: [np.interp(t - p[0] * 5, t, x)], [-0.5]),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 5)], [-0.5]),
    }
