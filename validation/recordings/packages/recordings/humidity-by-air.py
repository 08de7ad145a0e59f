"""Relative humidity over the temperature of the air, in a desert, a row each five minutes, three and a half days. Warm air holds more water by a bent law, and the water in the air changes."""

import numpy as np
from models.fitting import line
from models.lags import usual
from readers.edges_io import hut

HAND_BUILT = "water that drifts"


def rows(content):
    frame = hut(content)
    return {"time_s": frame.time_s, "air_c": frame.air_c, "humidity_pct": frame.ambient_hum}


def models(c):
    y, x, t = c["humidity_pct"], c["air_c"], c["time_s"]
    held = np.exp(-17.27 * x / (x + 237.3))
    return y, {
        **usual(y, x, t, 3600),
        "bent, and drift": line(y, x, x**2, t),
        "one amount of water": line(y, held),
        "water that drifts": line(y, held, held * t),
        "bent, drift, and its square": line(y, x, x**2, t, t**2),
    }
