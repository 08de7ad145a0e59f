"""Speed at which a dropsonde falls over the pressure of the air, from 14 km to the sea. The thinner the air, the faster; it floats in what rises."""

import numpy as np
from models.fitting import line
from models.lags import usual
from readers.pydropsonde import fall

HAND_BUILT = "root of the density"


def rows(content):
    frame = fall(content)
    return {"time_s": frame.time_s, "air_hpa": frame.hpa, "air_c": frame.degc, "down_m_s": -frame.up_m_s}


def models(c):
    y, x, t, degrees = c["down_m_s"], c["air_hpa"], c["time_s"], c["air_c"]
    return y, {
        **usual(y, x, t, 10),
        "temperature": line(y, x, degrees),
        "temperature, bent": line(y, x, degrees, degrees**2),
        "square, and temperature": line(y, x, x**2, degrees),
        HAND_BUILT: line(y, np.sqrt((degrees + 273) / x)),
    }
