"""Voltage at an input that tells 205 degC, so that no thermistor can be there, a row each half minute, four hours, and the temperature of the room. Next to nothing is missing."""

from models.fitting import line
from readers.edges_cal import load_thermistors

HAND_BUILT = "constant"


def rows(content):
    frame = load_thermistors(content)
    return {"time_s": frame.time_s, "room_c": frame.room_c, "input_mv": frame.lna_v * 1000}


def models(c):
    y, warm, t = c["input_mv"], c["room_c"], c["time_s"]
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "drift, and its square": line(y, t, t**2),
        "temperature": line(y, warm),
        "temperature, and drift": line(y, warm, t),
    }
