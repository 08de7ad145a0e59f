"""Light of the Sun from 0.05 to 0.4 nm over that from 0.1 to 0.8 nm, by two sensors of one satellite, a day with small flares, means of 15 readings. Each flare is hottest where it begins, and the short waves go before."""

import gzip

import numpy as np
from fitting import lag, line, terms
from reading import fits_tables, means

HAND_BUILT = "line and lag, and drift"


def rows(content):
    table = fits_tables(gzip.decompress(content))["FLUXES"]
    time, light = table["TIME"][0].astype(float), table["FLUX"][0].astype(float).reshape(-1, 2)
    kept = (light > 0).all(axis=1)
    time, long, short = (means(values[kept], 15) for values in (time, light[:, 0] * 1e6, light[:, 1] * 1e9))
    return {"time_s": time - time[0], "long_uw_m2": long, "short_nw_m2": short}


def models(c):
    y, x, t = c["short_nw_m2"], c["long_uw_m2"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 60, t, x)], [0.5]),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 60)], [0.5]),
        "line and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 600)], [1.0]),
        "line and lag, square": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 600), x**2], [1.0]),
        HAND_BUILT: terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 600), t], [1.0]),
    }
