"""Two thermometers in one aspirated shield on a glacier, beside sunshine (as its sensor tells it, in mV) and wind, one August, each 10 min. The second tells 40 K too much, as its makers meant it."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag, usual
from readers.pypromice import logger_table

HAND_BUILT = "sunshine, less in wind"


def rows(content):
    frame = logger_table(content, "Temperature_Avg", "ShortwaveRadiationIn_Avg", "WindSpeed", "Temperature2_Avg")
    return {
        "time_s": frame.time_s,
        "first_c": frame.Temperature_Avg,
        "sunshine_mv": frame.ShortwaveRadiationIn_Avg / 100,
        "wind_m_s": frame.WindSpeed,
        "second_c": frame.Temperature2_Avg,
    }


def models(c):
    y, x, t, sun, wind = c["second_c"], c["first_c"], c["time_s"], c["sunshine_mv"], c["wind_m_s"]
    return y, {
        **usual(y, x, t, 600),
        "wind": line(y, x, wind),
        "sunshine": line(y, x, sun),
        "sunshine, and wind": line(y, x, sun, wind),
        "late sunshine": terms(y, lambda p: [x, lag(sun, t, abs(p[0]) * 600)], [1.0]),
        "sunshine, and shift": terms(y, lambda p: [np.interp(t - p[0] * 600, t, x), sun], [0.5]),
        HAND_BUILT: line(y, x, sun, sun / (1 + wind)),
    }
