"""How strong radio of a station is over how far away it is, four walks with a receiver through a hall."""

import numpy as np
import pandas as pd
from models.bends import bends, levels_off
from models.fitting import line, scaled, terms
from readers.pnt_datasets import at_places

HAND_BUILT = "logarithm"
STATION = 3


def rows(*contents):
    *walks, stations = contents
    tables = []
    for run, (measured, places) in enumerate(zip(walks[::2], walks[1::2]), 1):
        _, powers, distances = at_places(measured, places, stations)
        tables.append(pd.DataFrame({"run": run, "distance_m": distances[STATION], "power_dbm": powers[STATION]}).dropna())
    columns = pd.concat(tables)
    return {name: columns[name].to_numpy() for name in columns}


def models(c):
    y, x, run = c["power_dbm"], c["distance_m"], c["run"]
    u, steps = scaled(x), [(run == k) * 1.0 for k in (2, 3, 4)]
    return y, {
        **bends(y, x),
        **levels_off(y, x, 10.0),
        "logarithm": line(y, np.log(x)),
        "logarithm, and line": line(y, np.log(x), x),
        "logarithm of what is farther": terms(y, lambda p: [np.log(x + abs(p[0]))], [1.0]),
        "logarithm, and steps": line(y, np.log(x), *steps),
        "cube, and steps": line(y, u, u**2, u**3, *steps),
    }
