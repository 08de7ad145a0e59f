"""One axis of two accelerometers in one case: one is read some 8 ms later. The shift is made between the rows of the recording."""

import numpy as np
from formats.text import csv
from models.fitting import line, terms

HAND_BUILT = "shift in time"


def rows(high, inertial):
    high, inertial = csv(high), csv(inertial)
    t, other = high.iloc[:, 0].to_numpy() / 1e6, inertial.iloc[:, 0].to_numpy() / 1e6
    both = (t > other[0]) & (t < other[-1])
    t, y = t[both], high.iloc[:, 1].to_numpy()[both]
    return {"time_s": t - t[0], "inertial_g": np.interp(t, other, inertial.iloc[:, 4].to_numpy()), "high_g": y}


def models(c):
    y, x, t = c["high_g"], c["inertial_g"], c["time_s"]
    return y, {"line": line(y, x), HAND_BUILT: terms(y, lambda p: [np.interp(t + p[0] * 0.01, t, x)], [0.1])}
