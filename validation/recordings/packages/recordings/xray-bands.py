"""Light of the Sun from 0.05 to 0.4 nm over that from 0.1 to 0.8 nm, by two sensors of one satellite, a day with small flares, means of 15 readings. Each flare is hottest where it begins, and the short waves go before."""

import gzip

from formats.rows import means
from models.fitting import terms
from models.lags import lag, usual
from readers.sunpy import fits_tables

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
        **usual(y, x, t),
        "line and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 600)], [1.0]),
        "line and lag, square": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 600), x**2], [1.0]),
        HAND_BUILT: terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 600), t], [1.0]),
    }
