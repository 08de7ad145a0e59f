"""Voltage of the battery of a glider, seven dives, beside its current. It sags under load and comes back late; at the start it settles."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.dbdreader import dinkum, glider_rows

HAND_BUILT = "late current and settling"


def rows(content, listing):
    kept = glider_rows(dinkum(content, listing), "m_battery", "m_coulomb_current")
    return {"time_s": kept.time_s, "battery_v": kept.m_battery, "current_a": kept.m_coulomb_current}


def models(c):
    y, i, t = c["battery_v"], c["current_a"], c["time_s"]
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "current": line(y, i),
        "current and drift": line(y, i, t),
        "late current": terms(y, lambda p: [lag(i, t, abs(p[0]) * 100)], [1.0]),
        "late current and drift": terms(y, lambda p: [lag(i, t, abs(p[0]) * 100), t], [1.0]),
        "current at two speeds": terms(y, lambda p: [lag(i, t, abs(q) * 100) for q in p], [0.5, 3.0]),
        HAND_BUILT: terms(y, lambda p: [lag(i, t, abs(p[0]) * 100), np.exp(-t / (abs(p[1]) * 500 + 1))], [1.0, 1.0]),
    }
