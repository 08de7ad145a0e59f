"""Temperature of a pouch cell above the air after its discharge in two hours has ended, 27 min."""

from formats.text import matrix
from models.drifts import comes_to_rest

HAND_BUILT = "exponential"
ENDS = 7309  # s


def rows(content):
    read = matrix(content)
    read = read[read[:, 0] >= ENDS]
    return {"time_s": read[:, 0] - read[0, 0], "above_air_k": read[:, 1]}


def models(c):
    return c["above_air_k"], comes_to_rest(c["above_air_k"], c["time_s"])
