"""Rudder of a glider beside the angle that it was told, one row a cycle of its computer. The fin is where it was told to be one cycle before."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.dbdreader import dinkum, glider_rows

HAND_BUILT = "shift"


def rows(content, listing):
    frame = dinkum(content, listing)[["m_present_time", "m_fin", "c_fin"]].ffill()
    kept = glider_rows(frame, "m_fin", "c_fin")
    return {"time_s": kept.time_s, "commanded_rad": kept.c_fin, "fin_rad": kept.m_fin}


def models(c):
    y, x, t = c["fin_rad"], c["commanded_rad"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        HAND_BUILT: terms(y, lambda p: [np.interp(t - p[0] * 5, t, x)], [0.5]),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 5)], [0.5]),
    }
