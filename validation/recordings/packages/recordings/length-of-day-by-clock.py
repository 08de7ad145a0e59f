"""What a day of the turning Earth is too long, beside what its clock lost from the day before to the day after, two years. The clock knows no more and no less."""

import numpy as np
from models.fitting import line
from readers.astropy_iers_data import earth_orientation

HAND_BUILT = "line"


def rows(content):
    t, clock = earth_orientation(content, 58119, 732, "UT1")
    _, excess = earth_orientation(content, 58119, 732, "LOD")
    return {"time_s": t[1:-1], "from_clock_ms": (clock[:-2] - clock[2:]) * 500, "excess_ms": excess[1:-1] * 1000}


def models(c):
    y, x, t = c["excess_ms"], c["from_clock_ms"], c["time_s"]
    return y, {
        HAND_BUILT: line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "rate": line(y, x, np.gradient(x)),
    }
