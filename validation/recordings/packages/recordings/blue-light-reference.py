"""What a fluorometer on a glider reads of its own blue light, one dive from 11 to 0 degC and back. The light is less in the cold, and the instrument is behind the water."""

import numpy as np
from formats.clock import since_first
from formats.netcdf import netcdf
from models.fitting import line, terms
from models.lags import lag

HAND_BUILT = "late temperature, bent, and drift"


def rows(content):
    frame = netcdf(content, {"time": "time", "water": "temperature_raw", "blue": "eng_wlbb2f_blueRef"}).dropna()
    return {"time_s": since_first(frame.time).round(3), "water_c": frame.water, "blue_count": frame.blue}


def models(c):
    y, x, t = c["blue_count"], c["water_c"], c["time_s"]
    late = lambda p: lag(x, t, abs(p) * 300)
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "temperature": line(y, x),
        "temperature, bent": line(y, x, x**2),
        "temperature, and drift": line(y, x, t),
        "late temperature": terms(y, lambda p: [late(p[0])], [1.0]),
        "late temperature, not at rest": terms(y, lambda p: [late(p[0]), np.exp(-t / (abs(p[0]) * 300 + 1))], [1.0]),
        "late temperature, bent": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [1.0]),
        "late temperature, and drift": terms(y, lambda p: [late(p[0]), t], [1.0]),
        "late temperature, bent, and drift": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2, t], [1.0]),
        "temperature, late twice": terms(y, lambda p: [lag(late(p[0]), t, abs(p[1]) * 300)], [1.0, 0.2]),
    }
