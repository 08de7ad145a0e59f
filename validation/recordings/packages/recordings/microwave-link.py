"""Loss of a microwave link of 10 km at 23 GHz over the rain that a radar saw along it, ten days in May in steps of 5 min: the loss grows less than in proportion; wet antennas add to it."""

import netCDF4
import numpy as np
from fitting import lag, line, terms

HAND_BUILT = "square"
LINK = 389


def rows(link, radar):
    with netCDF4.Dataset("link", memory=link) as file:
        sent, got = (np.ma.filled(file[name][:, LINK, 0].astype(float) if file[name].dimensions[0] == "time" else file[name][0, LINK, :].astype(float), np.nan) for name in ("tsl", "rsl"))
    with netCDF4.Dataset("radar", memory=radar) as file:
        rain = np.ma.filled(file["rainfall_amount"][:, LINK].astype(float), np.nan) * 12
    loss = sent - got
    loss = np.where(np.abs(loss) < 200, loss, np.nan).reshape(-1, 5).mean(axis=1)
    kept = np.isfinite(loss) & np.isfinite(rain)
    return {"time_s": np.flatnonzero(kept) * 300.0, "rain_mm_h": rain[kept], "loss_db": loss[kept]}


def models(c):
    y, x, t = c["loss_db"], c["rain_mm_h"], c["time_s"]
    wet = 1 - np.exp(-x / 0.3)
    return y, {
        "line": line(y, x),
        HAND_BUILT: line(y, x, x**2),
        "wet antennas": line(y, x, wet),
        "power": terms(y, lambda p: [np.maximum(x, 0) ** abs(p[0])], [0.8]),
        "power and lag": terms(y, lambda p: [np.maximum(lag(x, t, abs(p[1]) * 60), 0) ** abs(p[0])], [0.8, 5.0]),
        "power, and its lag": terms(y, lambda p: [np.maximum(x, 0) ** abs(p[0]), lag(np.maximum(x, 0) ** abs(p[0]), t, abs(p[1]) * 60)], [0.8, 10.0]),
    }
