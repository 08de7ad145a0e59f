"""Nitrogen oxides beside a Swiss motorway over what its cars give off, hourly for a year, both as logarithms: wind carries them away, and days differ."""

import numpy as np
from models.cycles import tone
from models.fitting import line
from readers.rdatasets import frame

HAND_BUILT = "wind"


def rows(content):
    d = frame(content)
    hour = np.asarray(d.rownames, float) if "rownames" in d and np.all(np.diff(np.asarray(d.rownames, float)) > 0) else np.arange(len(d)) * 1.0
    return {"time_s": (hour - hour[0]) * 3600, "log_emission": d.LNOxEm, "sqrt_wind": d.sqrtWS, "log_nox": d.LNOx}


def models(c):
    y, t, x, wind = c["log_nox"], c["time_s"], c["log_emission"], c["sqrt_wind"]
    day = [*tone(t, 86400.0), *tone(t, 43200.0)]
    return y, {"line": line(y, x), HAND_BUILT: line(y, x, wind), "square of wind": line(y, x, wind, wind**2), "wind and hour": line(y, x, wind, *day)}
