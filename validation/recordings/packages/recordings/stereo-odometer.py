"""How far aside a car is by two cameras on it, beside a satellite receiver: every fourth of 4541 pictures. The cameras' axes are a little turned, and errors of steps add up."""

import numpy as np
from models.fitting import line
from readers.evo import poses

HAND_BUILT = "north and drift"


def rows(content, truth, clock):
    seen, true = poses(content)[::4], poses(truth)[::4]
    t = np.array([float(line) for line in clock.decode().split()])[::4]
    return {"time_s": t, "true_m": true[:, 0], "camera_m": seen[:, 0], "north_m": true[:, 2]}


def models(c):
    y, x, north, t = c["camera_m"], c["true_m"], c["north_m"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "north": line(y, x, north),
        "gain by north": line(y, x, north * x / 100),
        "north, bent": line(y, x, north, (north / 100) ** 2),
        HAND_BUILT: line(y, x, north, t),
        "north, and late drift": line(y, x, north, t, (t / t.max()) ** 2),
    }
