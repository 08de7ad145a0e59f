"""How far north a car is by a camera on it, beside a satellite receiver: every fourth of 4541 pictures. The camera's axes are a little turned."""

import numpy as np
from models.fitting import line
from readers.evo import poses

HAND_BUILT = "aside, and gain by it"


def rows(content, truth, clock):
    seen, true = poses(content)[::4], poses(truth)[::4]
    t = np.array([float(line) for line in clock.decode().split()])[::4]
    return {"time_s": t, "true_m": true[:, 2], "camera_m": seen[:, 2], "aside_m": true[:, 0]}


def models(c):
    y, x, aside, t = c["camera_m"], c["true_m"], c["aside_m"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "aside": line(y, x, aside),
        "gain by aside": line(y, x, aside * x / 100),
        HAND_BUILT: line(y, x, aside, aside * x / 100),
        "aside, bent": line(y, x, aside, (aside / 100) ** 2),
        "aside and drift": line(y, x, aside, t),
    }
