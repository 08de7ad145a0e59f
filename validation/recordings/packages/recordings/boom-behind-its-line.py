"""Force at the boom that tows a ship's model over that in the line, while waves come."""

from models.fitting import terms
from models.lags import lag, moved, usual_and_shifts
from readers.qats import towing_tank

HAND_BUILT = "shift"


def rows(content):
    return towing_tank(content, line_n="FX_LINE_TOT", boom_n="FX_BOM_TOT")


def models(c):
    y, x, t = c["boom_n"], c["line_n"], c["time_s"]
    late = lambda p: lag(x, t, abs(p) * 0.05)
    return y, {
        **usual_and_shifts(y, x, t, 0.05),
        "lag, and square": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [0.5]),
        "lag, and drift": terms(y, lambda p: [late(p[0]), t], [0.5]),
        "shift, and lag": terms(y, lambda p: [lag(moved(x, t, p[1] * 0.05), t, abs(p[0]) * 0.05)], [0.5, 0.1]),
    }
