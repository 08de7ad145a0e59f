"""One instrument of a plant over another that goes with it, eleven days. Their difference goes with the time of day."""

from needles import instruments, plant

HAND_BUILT = "day"


def rows(content):
    return plant(content, first="tag90", second="tag98")


def models(c):
    return instruments(c)
