"""How turbid a river is over how much of it flows, during a storm. The mud comes five hours before the flood."""

from needles import mud, storm

HAND_BUILT = "shift ahead"


def rows(*contents):
    return storm(*contents, number=86)


def models(c):
    return mud(c)
