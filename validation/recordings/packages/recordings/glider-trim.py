"""Pitch of a glider under water over the place of the battery that trims it, six dives. The oil in the nose lifts it as well."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.dbdreader import dinkum, glider_rows

HAND_BUILT = "oil, bent"


def rows(content, listing):
    kept = glider_rows(dinkum(content, listing), "m_pitch", "m_battpos", "m_ballast_pumped", "m_depth")
    kept = kept[kept.m_depth > 2]
    return {"time_s": kept.time_s - kept.time_s.iloc[0], "battery_in": kept.m_battpos, "oil_cc": kept.m_ballast_pumped, "pitch_rad": kept.m_pitch}


def models(c):
    y, x, oil, t = c["pitch_rad"], c["battery_in"], c["oil_cc"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 20, t, x)], [0.5]),
        "oil": line(y, x, oil),
        "gain by oil": line(y, x, oil * x),
        "oil and drift": line(y, x, oil, t),
        HAND_BUILT: line(y, x, oil, (oil / 200) ** 2),
        "late oil": terms(y, lambda p: [x, lag(oil, t, abs(p[0]) * 20)], [0.5]),
    }
