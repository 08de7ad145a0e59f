"""How far a watch has turned as its gyroscope adds up, over how its accelerometer tells it, while an arm turns outward."""

from readers.seglearn import turn_models as models
from readers.seglearn import turned

HAND_BUILT = "drift, square, and shift"


def rows(content):
    return turned(content, 75, 0)
