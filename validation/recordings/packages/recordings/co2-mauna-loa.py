"""Carbon dioxide of the air at Mauna Loa, month by month: it rises ever faster, with a yearly cycle."""

import numpy as np
from models.cycles import tone
from models.fitting import line
from readers.rdatasets import frame

HAND_BUILT = "square, year and half a year"
YEAR = 365.25  # d


def rows(content):
    d = frame(content)
    return {"time_d": np.arange(len(d)) / 12.0 * YEAR, "co2_ppm": d.CO2.astype(float)}


def models(c):
    y, t = c["co2_ppm"], c["time_d"] / YEAR
    return y, {"line": line(y, t), "year": line(y, t, *tone(t, 1)), HAND_BUILT: line(y, t, t * t, *tone(t, 1), *tone(t, 0.5))}
