"""Vacuum inside the hull of a glider, six dives, beside the oil that its pump has moved out and the water around it. The oil leaves room to the air; the air cools and warms late."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.dbdreader import dinkum, glider_rows

HAND_BUILT = "oil, late temperature and drift"


def rows(content, listing, probe):
    kept = glider_rows(dinkum(content, listing), "m_vacuum", "m_ballast_pumped")
    water = dinkum(probe).dropna(subset=["sci_m_present_time", "sci_water_temp"])
    water = water[water.sci_water_temp > 1]
    degrees = np.interp(kept.m_present_time, water.sci_m_present_time, water.sci_water_temp)
    return {"time_s": kept.time_s, "vacuum_inhg": kept.m_vacuum, "oil_cc": kept.m_ballast_pumped, "water_c": degrees}


def models(c):
    y, oil, degrees, t = c["vacuum_inhg"], c["oil_cc"], c["water_c"], c["time_s"]
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "oil": line(y, oil),
        "oil and drift": line(y, oil, t),
        "late oil": terms(y, lambda p: [lag(oil, t, abs(p[0]) * 300)], [1.0]),
        "oil and temperature": line(y, oil, degrees),
        "oil and late temperature": terms(y, lambda p: [oil, lag(degrees, t, abs(p[0]) * 300)], [1.0]),
        "oil and late oil": terms(y, lambda p: [oil, lag(oil, t, abs(p[0]) * 300)], [1.0]),
        HAND_BUILT: terms(y, lambda p: [oil, lag(degrees, t, abs(p[0]) * 300), t], [1.0]),
    }
