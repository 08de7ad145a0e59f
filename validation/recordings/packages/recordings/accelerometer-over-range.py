"""One axis of an accelerometer that goes to 2.5 g over that of another that goes further, on the same board, 29 s of motion by hand."""

import numpy as np
from models.fitting import line, terms
from models.lags import usual
from readers.pyshimmer import motion_logger

HAND_BUILT = "clipped, and shift"


def rows(content):
    frame = motion_logger(content)
    return {"time_s": frame.time_s, "wide_m_s2": frame.Accel_WR_Y, "narrow_m_s2": frame.Accel_LN_Y}


def models(c):
    y, x, t = c["narrow_m_s2"], c["wide_m_s2"], c["time_s"]
    clipped = lambda u, p: np.clip(u, -25 * abs(p), 25 * abs(p))
    at = lambda p: np.interp(t - p * 0.02, t, x)
    return y, {
        **usual(y, x, t, 0.02),
        "cubic": line(y, x, x**2, x**3),
        "clipped": terms(y, lambda p: [clipped(x, p[0])], [0.9]),
        HAND_BUILT: terms(y, lambda p: [clipped(at(p[1]), p[0])], [0.9, -0.5]),
    }
