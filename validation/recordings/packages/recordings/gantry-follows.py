"""Angle of the gantry of a machine that irradiates over its command, 104 s, each 40 ms: it stands, turns by 250 degrees, and stands."""

import numpy as np
from models.fitting import line
from readers.pylinac import axis_models, trajectory

HAND_BUILT = "shift"


def rows(content):
    axes = trajectory(content)[::2]
    return {"time_s": np.arange(len(axes)) * 0.04, "told_deg": axes[:, 2], "went_deg": axes[:, 3]}


def models(c):
    y, x, t = c["went_deg"], c["told_deg"], c["time_s"]
    speed = np.gradient(x, t)
    return y, {**axis_models(y, x, t), "speed, and square": line(y, x, x**2, speed)}
