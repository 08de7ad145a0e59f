"""Losses of a microwave link of 10 km both ways, at 23.1 and 22.1 GHz, ten days in May in steps of 5 min: rain and air take from both alike."""

import numpy as np
from models.fitting import line, terms
from readers.pycomlink import link_loss

HAND_BUILT = "line"
LINK = 389


def rows(content):
    loss = link_loss(content, LINK)
    kept = np.isfinite(loss).all(axis=0)
    return {"time_s": np.flatnonzero(kept) * 300.0, "up_db": loss[0, kept], "down_db": loss[1, kept]}


def models(c):
    y, x, t = c["down_db"], c["up_db"], c["time_s"]
    return y, {"line": line(y, x), "square": line(y, x, (x - x.mean()) ** 2), "drift": line(y, x, t), "shift": terms(y, lambda p: [np.interp(t - p[0] * 300, t, x)], [0.1])}
