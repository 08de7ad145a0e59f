"""One axis of an accelerometer over that of another on the same board, 20 s of motion by hand, without the first ten seconds, in which one was out of range."""

import numpy as np
from models.fitting import line, terms
from models.lags import usual
from readers.pyshimmer import motion_logger

HAND_BUILT = "shift"


def rows(content):
    frame = motion_logger(content).iloc[700:]
    return {"time_s": frame.time_s - frame.time_s.iloc[0], "first_m_s2": frame.Accel_LN_X, "across_m_s2": frame.Accel_LN_Y, "along_m_s2": frame.Accel_LN_Z, "second_m_s2": frame.Accel_WR_X}


def models(c):
    y, x, t = c["second_m_s2"], c["first_m_s2"], c["time_s"]
    others = [c["across_m_s2"], c["along_m_s2"]]
    at = lambda p, u: np.interp(t - p * 0.02, t, u)
    return y, {
        **usual(y, x, t, 0.02),
        "other axes": line(y, x, *others),
        "shift, and other axes": terms(y, lambda p: [at(p[0], u) for u in (x, *others)], [0.5]),
    }
