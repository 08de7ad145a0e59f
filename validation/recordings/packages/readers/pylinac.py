"""Reads files of the package pylinac, and holds models that its recordings share."""

import struct

import numpy as np
from models.fitting import line
from models.lags import usual


def trajectory(content):
    """Axes of a machine that irradiates, one snapshot each 20 ms: a command and an answer a column pair, in the order of its file; 13 axes, then carriages and leaves."""
    axes = struct.unpack_from("<i", content, 40)[0]
    samples = struct.unpack_from(f"<{axes}i", content, 44 + 4 * axes)
    _, beams, _, snapshots = struct.unpack_from("<4i", content, 44 + 8 * axes)
    wide = 2 * sum(samples)
    return np.frombuffer(content, "<f4", wide * snapshots, 1024 + 80 * beams).reshape(snapshots, wide).astype(float)


def axis_models(y, x, t, unit=0.05):
    """Models of an axis `y` that follows its command `x`."""
    speed = np.gradient(x, t)
    return {
        **usual(y, x, t, unit),
        "speed": line(y, x, speed),
        "direction": line(y, x, np.sign(speed)),
    }
