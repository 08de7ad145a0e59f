"""A thermometer of a low-pressure impactor that was switched on, almost five hours, every fifth second."""

from models.drifts import comes_to_rest
from readers.aerosoltools import impactor

HAND_BUILT = "exponential"


def rows(content):
    frame = impactor(content)
    return {"time_s": frame.time_s, "inside_c": frame.Temperature3}


def models(c):
    return c["inside_c"], comes_to_rest(c["inside_c"], c["time_s"])
