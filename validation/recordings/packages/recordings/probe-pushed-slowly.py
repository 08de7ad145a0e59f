"""How high a pole is as its barometer tells, over how its acceleration adds up, while it is pushed slowly by half a metre in 2 seconds."""

from readers.study_lyte import depth_models as models
from readers.study_lyte import depths

HAND_BUILT = "cube"


def rows(content):
    return depths(content)
