"""Losses of a microwave link of 10 km both ways, at 23.1 and 22.1 GHz, ten days in May in steps of 5 min: rain and air take from both alike."""

import netCDF4
import numpy as np
from fitting import line, terms

HAND_BUILT = "line"
LINK = 389


def rows(content):
    with netCDF4.Dataset("link", memory=content) as file:
        at = file["tsl"].dimensions.index("time")
        sent, got = (np.ma.filled(file[name][:].astype(float), np.nan) for name in ("tsl", "rsl"))
        order = [file["tsl"].dimensions.index(name) for name in ("channel_id", "cml_id")] + [at]
    loss = np.transpose(sent - got, order)[:, LINK, :]
    loss = np.where(np.abs(loss) < 200, loss, np.nan).reshape(2, -1, 5).mean(axis=2)
    kept = np.isfinite(loss).all(axis=0)
    return {"time_s": np.flatnonzero(kept) * 300.0, "up_db": loss[0, kept], "down_db": loss[1, kept]}


def models(c):
    y, x, t = c["down_db"], c["up_db"], c["time_s"]
    return y, {"line": line(y, x), "square": line(y, x, (x - x.mean()) ** 2), "drift": line(y, x, t), "shift": terms(y, lambda p: [np.interp(t - p[0] * 300, t, x)], [0.1])}
