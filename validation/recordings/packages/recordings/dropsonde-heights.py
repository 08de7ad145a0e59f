"""Height of a falling dropsonde by satellites over that which is made of its pressure, from 14 km to the sea. The one by pressure counts geopotential metres from below and drifts apart with height."""

from models.fitting import line
from models.lags import usual
from readers.pydropsonde import fall

HAND_BUILT = "square"


def rows(content):
    frame = fall(content)
    return {"time_s": frame.time_s, "barometer_m": frame.height, "satellites_m": frame.gps_height}


def models(c):
    y, x, t = c["satellites_m"], c["barometer_m"], c["time_s"]
    return y, {**usual(y, x, t, 1), "square, and drift": line(y, x, x**2, t)}
