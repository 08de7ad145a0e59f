"""Temperature of a pouch cell above the air after its discharge in two hours has ended, 27 min."""

from loggers import pairs, rests

HAND_BUILT = "exponential"
ENDS = 7309  # s


def rows(content):
    read = pairs(content)
    read = read[read[:, 0] >= ENDS]
    return {"time_s": read[:, 0] - read[0, 0], "above_air_k": read[:, 1]}


def models(c):
    return c["above_air_k"], rests(c["above_air_k"], c["time_s"])
