"""Temperature inside of a counter of fine particles that was switched on, 72 min, every fourth row."""

from models.drifts import comes_to_rest
from readers.aerosoltools import partector

HAND_BUILT = "exponential"


def rows(content):
    frame = partector(content)
    return {"time_s": frame.time - frame.time.iloc[0], "inside_c": frame["T"]}


def models(c):
    return c["inside_c"], comes_to_rest(c["inside_c"], c["time_s"])
