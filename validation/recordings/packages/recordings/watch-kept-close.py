"""How far a watch has turned as its gyroscope adds up, over how its accelerometer tells it, while an arm rows and turns little."""

from readers.seglearn import turn_models as models
from readers.seglearn import turned

HAND_BUILT = "line"


def rows(content):
    return turned(content, 52, 2)
