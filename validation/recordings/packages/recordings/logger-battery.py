"""Voltage of the battery of a logger over its temperature, two years, each 8 hours. It is told in steps of 0.05 V."""

from models.fitting import line
from readers.tsp import thermistor_string

HAND_BUILT = "temperature, bent"


def rows(content):
    frame = thermistor_string(content).iloc[1:]
    return {"time_s": frame.time_s - frame.time_s.iloc[0], "logger_c": frame.logger_c, "battery_v": frame.battery_v}


def models(c):
    y, x, t = c["battery_v"], c["logger_c"], c["time_s"]
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "temperature": line(y, x),
        HAND_BUILT: line(y, x, x**2),
        "temperature, and drift": line(y, x, t),
    }
