"""How far the tower of a wind turbine pitches over how far its float does, by cameras, in waves of a basin. The tower bends where its head is pushed."""

from models.drivers import of_drivers
from models.fitting import line, scaled, terms
from models.lags import moved
from readers.qats import wave_basin

HAND_BUILT = "square, and acceleration"


def rows(content):
    return wave_basin(content, float_deg="FLOATER_PITCH", acceleration_m_s2="X_ACC_TOWER", tower_deg="TOWER_PITCH")


def models(c):
    y, x, w, t = c["tower_deg"], c["float_deg"], c["acceleration_m_s2"], c["time_s"]
    u = scaled(x)
    return y, {
        **of_drivers(y, x, acceleration=w),
        "acceleration, and drift": line(y, x, w, t),
        "late acceleration": terms(y, lambda p: [x, moved(w, t, p[0] * 0.05)], [0.5]),
        "shift, and acceleration": terms(y, lambda p: [moved(x, t, p[0] * 0.05), w], [0.5]),
        "cube, and acceleration": line(y, x, u**2, u**3, w),
        "square, acceleration, and square of it": line(y, x, u**2, w, w**2),
        "square, and late acceleration": terms(y, lambda p: [u, u**2, moved(w, t, p[0] * 0.05)], [0.5]),
    }
