"""Reads files of the package seglearn: a watch that tells accelerations in g and rates of turn in rad/s, 50 rows a second, while an arm is moved."""

import io

import numpy as np
from formats import pickled
from formats.rows import summed
from models.drifts import usual_shifts_and_drifts
from models.fitting import line, scaled, terms
from models.lags import moved

RATE_HZ = 50
ACROSS = {0: (1, 2), 1: (0, 2), 2: (0, 1)}  # of each axis the two that it turns


def watches(content):
    """What the file holds: lists by name. It is an array of numpy around one pickled object."""
    file = io.BytesIO(content)
    np.lib.format.read_magic(file)
    np.lib.format.read_array_header_1_0(file)
    return pickled.plain(file.read()).item()


def turned(content, number, axis):
    """How far a watch has turned about an axis, rad: as the accelerations tell, by the way down, and as the rate of turn adds up from the first row on."""
    told = np.asarray(watches(content)["X"][number], float)
    t, (one, other) = np.arange(len(told)) / RATE_HZ, ACROSS[axis]
    return {"time_s": t, "tilt_rad": np.unwrap(np.arctan2(told[:, one], told[:, other])), "turned_rad": summed(told[:, 3 + axis], t)}


def turn_models(c):
    """Models of what a rate of turn adds up to over the tilt: drifts, bends, shifts, and their sums."""
    y, x, t = c["turned_rad"], c["tilt_rad"], c["time_s"]
    u, w = scaled(x), scaled(t)
    at = lambda p: moved(u, t, p[0] * 0.1)
    return y, {
        **usual_shifts_and_drifts(y, x, t, 0.1),
        "drift, square, and cube": line(y, x, w, u**2, u**3),
        "drift, its square, and square": line(y, x, w, w**2, u**2),
        "drift, its square and cube": line(y, x, w, w**2, w**3),
        "drift, and shift": terms(y, lambda p: [at(p), w], [0.3]),
        "drift, square, and shift": terms(y, lambda p: [at(p), at(p) ** 2, w], [0.3]),
        "drift, and slope that drifts, and square": line(y, x, w, u * w, u**2),
    }
