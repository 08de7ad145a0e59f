"""How turbid a river is over how much of it flows, during a storm. The mud comes five hours before the flood."""

from readers.hysom import storm, turbidity_models

HAND_BUILT = "shift ahead"


def rows(*contents):
    return storm(*contents, number=86)


def models(c):
    return turbidity_models(c)
