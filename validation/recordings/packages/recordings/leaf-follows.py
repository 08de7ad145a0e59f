"""Place of a leaf of a collimator over its command, 43 s, each 20 ms. The leaf is late by some milliseconds."""

import numpy as np
from readers.pylinac import axis_models, trajectory

HAND_BUILT = "shift"


def rows(content):
    axes = trajectory(content)
    return {"time_s": np.arange(len(axes)) * 0.02, "told_mm": axes[:, 106] * 10, "went_mm": axes[:, 107] * 10}


def models(c):
    return c["went_mm"], axis_models(c["went_mm"], c["told_mm"], c["time_s"])
