"""How far a knee is bent as a laboratory works it out from all its markers, over how three of them tell it; a person who had a stroke."""

import numpy as np
from models.drifts import usual_shifts_and_drifts
from models.fitting import line, scaled, terms
from models.lags import moved
from readers.gaitkit import walk

HAND_BUILT = "cube that is shifted"


def rows(content):
    t, angles, markers = walk(content)
    thigh, shank = (markers[f"right_{end}"] - markers["right_knee"] for end in ("hip", "ankle"))
    straight = (thigh * shank).sum(axis=1) / np.linalg.norm(thigh, axis=1) / np.linalg.norm(shank, axis=1)
    return {"time_s": t, "markers_deg": 180 - np.degrees(np.arccos(straight)), "knee_deg": angles["right_knee_angle"]}


def models(c):
    y, x, t = c["knee_deg"], c["markers_deg"], c["time_s"]
    u, w = scaled(x), scaled(t)
    at = lambda p: moved(u, t, p[0] * 0.01)
    return y, {
        **usual_shifts_and_drifts(y, x, t, 0.01),
        "cube, and drift": line(y, x, u**2, u**3, w),
        "cube that is shifted": terms(y, lambda p: [at(p) ** k for k in (1, 2, 3)], [0.3]),
    }
