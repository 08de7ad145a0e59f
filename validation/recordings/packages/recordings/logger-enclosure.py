"""Temperature inside the box of a data logger over that of the air, a winter week: by day the sun warms it, on some days and more where there is no wind, and no column tells. Means of 5 min."""

import numpy as np
import pandas as pd
from formats.netcdf import netcdf
from formats.rows import means
from models.cycles import tone
from models.fitting import line, terms
from models.lags import lag

HAND_BUILT = "two lags, and hours of the day"
DAY = 86400.0  # s


def rows(*days):
    names = {"air_c": "temp_mean", "wind_m_s": "wspd_arith_mean", "logger_c": "logger_temp"}
    d = pd.concat([netcdf(day, names) for day in days])
    out = {name: means(d[name], 5) for name in names}
    return {"time_s": np.arange(len(out["air_c"])) * 300.0, **out}


def models(c):
    y, x, t, wind = c["logger_c"], c["air_c"], c["time_s"], c["wind_m_s"]
    day = [*tone(t, DAY), *tone(t, DAY / 2)]

    def lags(p):
        return [lag(x, t, abs(tau) * 3600) for tau in p]

    return y, {
        "line": line(y, x),
        "one lag": terms(y, lags, [1.0]),
        "two lags": terms(y, lags, [0.5, 5.0]),
        "one lag, and hours of the day": terms(y, lambda p: [*lags(p), *day], [1.0]),
        HAND_BUILT: terms(y, lambda p: [*lags(p), *day], [0.5, 5.0]),
        "one lag, hours and wind": terms(y, lambda p: [*lags(p), *day, wind], [1.0]),
    }
