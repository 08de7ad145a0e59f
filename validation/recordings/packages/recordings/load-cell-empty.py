"""Third load cell of a platform on which nobody stands, 22 s, means of a hundredth of a second. Nothing is missing."""

import numpy as np
from formats.rows import means
from models.fitting import line
from readers.biosignalsnotebooks import hubs, seconds_at

HAND_BUILT = "constant"


def rows(content):
    third = means(list(hubs(content).values())[2][:11000], 5)
    return {"time_s": seconds_at(third, 100), "load_count": third}


def models(c):
    y, t = c["load_count"], c["time_s"]
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "drift, and its square": line(y, t, t**2),
        "logarithm": line(y, np.log1p(t)),
    }
