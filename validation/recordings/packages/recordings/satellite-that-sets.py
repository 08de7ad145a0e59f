"""How strong a satellite is, in dB, more than five hours until it sets."""

import numpy as np
from models.cycles import tone
from models.drifts import courses
from models.fitting import line, scaled
from models.jumps import changed
from readers.georinex import observed

HAND_BUILT = "drift, and its square"


def rows(content):
    told = observed(content, "E05", "S1C")
    return {"time_s": told["time_s"], "e1_dbhz": told["S1C"]}


def models(c):
    y, t = c["e1_dbhz"], c["time_s"]
    w = scaled(t)
    return y, {
        **courses(y, t),
        "drift, its powers to the fourth": line(y, w, w**2, w**3, w**4),
        "logarithm": line(y, np.log(t + 60)),
        "drift, its square, and step": changed(y, t, [w, w**2], 1.0),
        "drift, its square, and a wave of twenty minutes": line(y, w, w**2, *tone(t, 1200)),
    }
