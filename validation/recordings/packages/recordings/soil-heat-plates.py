"""Heat into the soil by two plates some metres apart under grass, two days of November in half hours, one a run.

They differ with the heat that the sun brings and the sky takes, an hour or so later.
"""

import numpy as np
import pandas as pd
from formats.netcdf import netcdf
from models.fitting import line, terms
from models.lags import lag

HAND_BUILT = "lagged radiation"
NAMES = {"first_w_m2": "soil_heat_flow_1", "net_w_m2": "net_radiation", "second_w_m2": "soil_heat_flow_2"}
BEGINS = (0.0, 5 * 86400.0)  # s, of the two days


def rows(*days):
    parts = [netcdf(day, NAMES).assign(day=k, time_s=lambda d, k=k: BEGINS[k - 1] + d.index * 1800.0) for k, day in enumerate(days, 1)]
    d = pd.concat(parts).dropna()
    d = d[(d[list(NAMES)].abs() < 2000).all(axis=1)]
    return {name: d[name] for name in ("day", "time_s", *NAMES)}


def models(c):
    y, x, net, t, day = c["second_w_m2"], c["first_w_m2"], c["net_w_m2"], c["time_s"], c["day"]

    def late(u, hours):
        out = np.empty(len(u))
        for k in np.unique(day):
            out[day == k] = lag(u[day == k], t[day == k], abs(hours) * 3600)
        return out

    return y, {
        "line": line(y, x),
        "lag": terms(y, lambda p: [late(x, p[0])], [1.0]),
        "lead": terms(y, lambda p: [x, late(x, p[0])], [1.0]),
        "radiation": line(y, x, net),
        HAND_BUILT: terms(y, lambda p: [x, late(net, p[0])], [0.5]),
        "lag and radiation": terms(y, lambda p: [late(x, p[0]), net], [1.0]),
        "hours and radiation": line(y, x, net, t % 86400),
    }
