"""Heat of a field of solar collectors over the sun on it, 5 min, ten days of May: flow, warming and 3.8 MJ/(m3 K) of the fluid. It warms before it gives, and gives nothing to a faint sun."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.sunpeek_exampledata import collectors

HAND_BUILT = "lag, cubic"


def rows(content):
    frame = collectors(content, "2017-05-06 23:00", "2017-05-16 23:00", 5)
    power = 3800 * frame.vf * (frame.te_out - frame.te_in)
    return {"time_s": frame.time_s, "sun_w_m2": frame.rd_gti, "power_kw": power}


def models(c):
    y, x, t = c["power_kw"], c["sun_w_m2"], c["time_s"]
    late = lambda p: lag(x, t, abs(p[0]) * 300)
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 300, t, x)], [1.0]),
        "lag": terms(y, lambda p: [late(p)], [1.0]),
        "lag, square": terms(y, lambda p: [late(p), late(p) ** 2], [1.0]),
        HAND_BUILT: terms(y, lambda p: [late(p), late(p) ** 2, late(p) ** 3], [1.0]),
        "lag, and drift": terms(y, lambda p: [late(p), t], [1.0]),
    }
