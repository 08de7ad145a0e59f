"""Oil in the bladder of a glider, as the potentiometer of its pump tells, over what was told to the pump, 19 hours of dives, a row each 20 s. The pump moves 16 cm3/s, so it is there some 50 s later."""

import numpy as np
from models.fitting import terms
from models.lags import lag, usual
from readers.pyglider import glider

HAND_BUILT = "two shifts"


def rows(*contents):
    frame = glider(*contents)
    return {"time_s": frame.time_s, "told_cm3": frame.BallastCmd, "ballast_cm3": frame.BallastPos}


def models(c):
    y, x, t = c["ballast_cm3"], c["told_cm3"], c["time_s"]
    at = lambda p: np.interp(t - p * 20, t, x)
    return y, {
        **usual(y, x, t),
        HAND_BUILT: terms(y, lambda p: [at(p[0]), at(p[1])], [0.5, 2.0]),
        "shift, and lag": terms(y, lambda p: [lag(at(p[0]), t, abs(p[1]) * 20)], [0.5, 0.5]),
    }
