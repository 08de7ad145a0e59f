"""Torque on the slime of a slug over the angle of a rheometer that swings at 3 rad/s. What is viscous goes before what is elastic, and it stiffens where the strain is large."""

import numpy as np
from models.fitting import line
from models.lags import usual

HAND_BUILT = "rate, and both stiffen"


def rows(content):
    lines = [line.split() for line in content.decode().splitlines() if line[:1].isdigit()]
    t, angle, torque = np.array([[float(v) for v in line] for line in lines]).T
    kept = np.append(True, np.diff(t) > 0)
    return {"time_s": t[kept], "angle_rad": angle[kept], "torque_unm": torque[kept] * 1e6}


def models(c):
    y, x, t = c["torque_unm"], c["angle_rad"], c["time_s"]
    rate = np.gradient(x, t)
    return y, {
        **usual(y, x, t, 0.3),
        "cubic": line(y, x, x**3),
        "rate": line(y, x, rate),
        "rate, cubic": line(y, x, rate, x**3),
        HAND_BUILT: line(y, x, rate, x**3, rate**3),
    }
