"""Dust below 20 micrometres over that below 10 by one counter beside mirrors, a week each five minutes. How much is coarse goes with what is finer still."""

from models.fitting import line
from models.lags import usual
from readers.mirror_soiling_data import weather

HAND_BUILT = "finer"


def rows(content):
    frame = weather(content)
    return {"time_s": frame.time_s, "pm10_ug_m3": frame.PM10, "pm4_ug_m3": frame.PM4, "pm20_ug_m3": frame.PM20}


def models(c):
    y, x, t, fine = c["pm20_ug_m3"], c["pm10_ug_m3"], c["time_s"], c["pm4_ug_m3"]
    return y, {
        **usual(y, x, t, 300),
        "finer": line(y, x, fine),
        "finer, and square": line(y, x, fine, x**2),
        "finer, bent": line(y, x, fine, fine**2),
        "finer, and drift": line(y, x, fine, t),
        "slope by finer": line(y, x, fine, x * fine),
        "slope by finer, and square": line(y, x, fine, x * fine, x**2),
        "all squares": line(y, x, fine, x * fine, x**2, fine**2),
    }
