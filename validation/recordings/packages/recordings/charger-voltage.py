"""Voltage of a buffer battery that is kept charged, over the temperature beside it, a day in July, every minute.

The charger lowers it by 14 mV/K, as such chargers do, and the battery warms some twenty minutes later than the thermometer. Read in steps of 10 mV.
"""

import numpy as np
from formats.netcdf import netcdf
from models.fitting import line, terms
from models.lags import lag

HAND_BUILT = "lag"


def rows(content):
    names = {"logger_c": "logger_temp", "supply_v": "logger_volt"}
    d = netcdf(content, names)
    return {"time_s": np.arange(len(d)) * 60.0, **{name: d[name] for name in names}}


def models(c):
    y, x, t = c["supply_v"], c["logger_c"], c["time_s"]
    return y, {"line": line(y, x), "square": line(y, x, x**2), HAND_BUILT: terms(y, lambda p: [lag(x, t, abs(p[0]) * 60)], [20.0]), "drift": line(y, x, t)}
