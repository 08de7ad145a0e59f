"""Two thermometers of the air at one site, hourly, four winter months. They agree but for what the air does between them."""

import numpy as np
from models.cycles import tone
from models.fitting import line, terms
from readers.neptoon import weather_pair

HAND_BUILT = "line"


def rows(content):
    frame = weather_pair(content)
    return {"time_s": frame.time_s, "second_c": frame.AirTemperature_Sensor2, "first_c": frame.AirTemperature}


def models(c):
    y, x, t = c["first_c"], c["second_c"], c["time_s"]
    return y, {
        HAND_BUILT: line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "shift": terms(y, lambda p: [np.interp(t - p[0] * 3600, t, x)], [0.1]),
        "hours of the day": line(y, x, *tone(t, 86400)),
    }
