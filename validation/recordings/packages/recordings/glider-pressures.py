"""Pressure sensor in the hull of a glider beside that of its water probe, six dives to 40 m. The hull's reading is older by a second or two."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.dbdreader import dinkum, glider_rows

HAND_BUILT = "shift"


def rows(content, listing):
    kept = glider_rows(dinkum(content, listing), "m_pressure", "sci_water_pressure")
    kept = kept[kept.sci_water_pressure.diff() != 0]
    return {"time_s": kept.time_s, "water_bar": kept.sci_water_pressure, "hull_bar": kept.m_pressure}


def models(c):
    y, x, t = c["hull_bar"], c["water_bar"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        HAND_BUILT: terms(y, lambda p: [np.interp(t - p[0] * 5, t, x)], [0.5]),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 5)], [0.5]),
        "rate": line(y, x, np.gradient(x, t)),
    }
