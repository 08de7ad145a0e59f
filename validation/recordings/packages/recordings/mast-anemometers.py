"""Two anemometers on opposite booms of a mast: each reads low in the shadow of the mast, over some ten degrees of direction."""

import numpy as np
import pandas as pd
from formats.clock import seconds
from formats.text import csv
from models.fitting import line, terms

HAND_BUILT = "two shadows over direction"


def rows(content):
    d = csv(content, encoding="utf-8-sig").iloc[20000:24000]
    d = d.assign(t=pd.to_datetime(d.Timestamp))
    d = d.dropna(subset=["Spd80mN", "Spd80mS", "Dir78mS", "T2m"])
    d = d[(d.Spd80mN > 1) & (d.Spd80mS > 1)]
    return {"time_s": seconds(d.t), "speed_north": d.Spd80mN, "direction_deg": d.Dir78mS, "temperature_c": d.T2m, "speed_south": d.Spd80mS}


def angle(degrees, centre, width):
    """A bell over an angle, 1 at its centre; centre and width in rad."""
    away = (np.radians(degrees) - centre + np.pi) % (2 * np.pi) - np.pi
    return np.exp(-0.5 * (away / width) ** 2)


def models(c):
    y, x, direction = c["speed_south"], c["speed_north"], c["direction_deg"]

    def shadows(p):
        return [x, x * angle(direction, p[0], p[2]), x * angle(direction, p[1], p[3])]

    return y, {"line": line(y, x), HAND_BUILT: terms(y, shadows, [0.0, np.pi, 0.3, 0.3])}
