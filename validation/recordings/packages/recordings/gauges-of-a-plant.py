"""One instrument of a plant over another beside it, eleven days. One goes with the day, and on the eighth it comes to tell more."""

from needles import instruments, plant

HAND_BUILT = "day, and step"


def rows(content):
    return plant(content, first="tag26", second="tag31")


def models(c):
    return instruments(c)
