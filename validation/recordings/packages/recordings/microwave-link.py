"""Loss of a microwave link of 10 km at 23 GHz over the rain along it by a reference, ten days in May in steps of 5 min: the loss grows less than in proportion; wet antennas add to it."""

import numpy as np
from formats.netcdf import dataset, filled
from models.fitting import line, terms
from models.lags import lag
from readers.pycomlink import link_loss

HAND_BUILT = "square"
LINK = 389


def rows(links, reference):
    loss = link_loss(links, LINK)[0]
    with dataset(reference) as file:
        rain = filled(file["rainfall_amount"])[:, LINK] * 12
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
