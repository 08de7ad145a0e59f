"""Pressure in a car over its height, a drive of 43 minutes. Weather changes it, and the air that flows past a car that is fast."""

import numpy as np
from models.drivers import of_drivers
from models.fitting import line, scaled, terms
from models.lags import lag, moved
from readers.pntos_cobra_datasets_lcm import drive_by_pressure

HAND_BUILT = "drift, and speed in square"


def rows(content):
    return drive_by_pressure(content)


def models(c):
    y, x, t, speed = c["pressure_hpa"], c["height_m"], c["time_s"], c["speed_m_s"]
    u, w, v = scaled(x), scaled(t), speed**2
    return y, {
        **of_drivers(y, x, speed=speed),
        "drift": line(y, x, w),
        "drift, and its square": line(y, x, w, w**2),
        "drift that fades": terms(y, lambda p: [x, np.exp(-t / abs(p[0]))], [1000.0]),
        "speed in square": line(y, x, v),
        "drift, and speed": line(y, x, w, speed),
        "drift, and speed in square": line(y, x, w, v),
        "drift, speed in square, and square": line(y, x, u**2, w, v),
        "drift, its square, and speed in square": line(y, x, w, w**2, v),
        "drift, and speed in square a while later": terms(y, lambda p: [x, w, lag(v, t, abs(p[0]))], [5.0]),
        "drift, speed in square, and shift": terms(y, lambda p: [moved(x, t, p[0]), w, v], [1.0]),
    }
