"""Temperature inside of a counter of fine particles that was switched on, 72 min, every fourth row."""

from loggers import partector, rests

HAND_BUILT = "exponential"


def rows(content):
    frame = partector(content)
    return {"time_s": frame.time - frame.time.iloc[0], "inside_c": frame["T"]}


def models(c):
    return c["inside_c"], rests(c["inside_c"], c["time_s"])
