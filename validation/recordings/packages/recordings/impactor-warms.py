"""A thermometer of a low-pressure impactor that was switched on, almost five hours, every fifth second."""

from loggers import impactor, rests

HAND_BUILT = "exponential"


def rows(content):
    frame = impactor(content)
    return {"time_s": frame.time_s, "inside_c": frame.Temperature3}


def models(c):
    return c["inside_c"], rests(c["inside_c"], c["time_s"])
