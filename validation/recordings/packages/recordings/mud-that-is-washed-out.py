"""How turbid a river is over how much of it flows, during a storm. Mud comes as the water rises, and is washed out before it falls."""

from readers.hysom import storm, turbidity_models

HAND_BUILT = "line, and lag"


def rows(*contents):
    return storm(*contents, number=33)


def models(c):
    return turbidity_models(c)
