"""Load of the grid of Victoria over the temperature in Melbourne, half hours of a year: heating and cooling, the hour of the day, work."""

import numpy as np
from models.cycles import tone
from models.fitting import line, terms
from readers.rdatasets import frame

HAND_BUILT = "hinges, hour and work"


def rows(content):
    d = frame(content)
    return {"time_s": np.arange(len(d)) * 1800.0, "air_c": d.Temperature, "work_day": d.WorkDay, "load_gw": d.Demand}


def models(c):
    y, t, air, work = c["load_gw"], c["time_s"], c["air_c"], c["work_day"]
    day = [wave for k in (1, 2, 3, 4) for wave in tone(t, 86400.0 / k)]
    hinges = terms(y, lambda p: [air, np.maximum(air - p[0], 0)], [18.0])
    whole = terms(y, lambda p: [air, np.maximum(air - p[0], 0), work, *day], [18.0])
    return y, {"line": line(y, air), "hinge": hinges, "work": line(y, air, work), "hour": line(y, air, *day), HAND_BUILT: whole}
