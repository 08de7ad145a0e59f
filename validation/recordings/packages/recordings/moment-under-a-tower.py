"""Moment at the foot of a wind turbine's tower over how its head is accelerated, in waves of a basin. The foot, which is on a float, is accelerated too."""

import numpy as np
from models.drivers import of_drivers
from models.fitting import line, terms
from models.lags import lag, moved
from readers.qats import wave_basin

HAND_BUILT = "shift of both"


def rows(content):
    told = wave_basin(content, tower_m_s2="X_ACC_TOWER", float_m_s2="X_ACC_FLOATER", moment_mnm="MY_BOT")
    return {**told, "moment_mnm": told["moment_mnm"] / 1e6}


def models(c):
    y, x, w, t = c["moment_mnm"], c["tower_m_s2"], c["float_m_s2"], c["time_s"]
    by = lambda p: [moved(k, t, p * 0.05) for k in (x, w)]
    return y, {
        **of_drivers(y, x, float=w),
        "shift": terms(y, lambda p: by(p[0])[:1], [-0.5]),
        "shift of both": terms(y, lambda p: by(p[0]), [-0.5]),
        "shift of each": terms(y, lambda p: [by(p[0])[0], by(p[1])[1]], [-0.5, -0.5]),
        "lag of both": terms(y, lambda p: [lag(k, t, abs(p[0]) * 0.05) for k in (x, w)], [0.5]),
        "shift of both, and square": terms(y, lambda p: [*by(p[0]), by(p[0])[0] ** 2], [-0.5]),
        "shift of both, and drift": terms(y, lambda p: [*by(p[0]), t], [-0.5]),
        "both, and how fast they change": line(y, x, w, np.gradient(x, t), np.gradient(w, t)),
    }
