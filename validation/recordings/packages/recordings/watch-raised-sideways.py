"""How far a watch has turned as its gyroscope adds up, over how its accelerometer tells it, while an arm is raised to the side."""

from readers.seglearn import turn_models as models
from readers.seglearn import turned

HAND_BUILT = "drift, square, and cube"


def rows(content):
    return turned(content, 128, 1)
