"""Counts of one pixel over those of its neighbour but one while a grating turns in 800 steps, through a film of polystyrene. What one pixel sees the other one sees some steps later, and ever fewer."""

import numpy as np
from models.lags import late_shifts
from readers.skultrafast import grating

HAND_BUILT = "shift that changes"


def rows(content):
    first, second = grating(content, 64, 62)
    return {"step_s": np.arange(len(first)), "first_counts": first, "second_counts": second}


def models(c):
    y, x, t = c["second_counts"], c["first_counts"], c["step_s"]
    return y, late_shifts(y, x, t, 1, 5.0, -3.0)
