"""Pressure of the air beside a wind turbine, ten minutes, with the wind and the power of the turbine. Nothing moves it."""

from models.fitting import line, terms
from models.lags import lag
from readers.wetb import turbine_sensors

HAND_BUILT = "constant"


def rows(content):
    read = turbine_sensors(content)
    return {"time_s": read["time_s"], "wind_m_s": read["WspThies"], "power_kw": read["Power"], "air_hpa": read["AirPress"]}


def models(c):
    y, t, wind, power = c["air_hpa"], c["time_s"], c["wind_m_s"], c["power_kw"]
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "drift, and its square": line(y, t, t**2),
        "wind": line(y, wind),
        "square of the wind": line(y, wind**2),
        "power": line(y, power),
        "wind, and power": line(y, wind, power),
        "late wind": terms(y, lambda p: [lag(wind, t, abs(p[0]) * 10)], [0.5]),
        "late power": terms(y, lambda p: [lag(power, t, abs(p[0]) * 10)], [0.5]),
    }
