"""How far a watch has turned as its gyroscope adds up, over how its accelerometer tells it, while an arm rows."""

from readers.seglearn import turn_models as models
from readers.seglearn import turned

HAND_BUILT = "drift, and slope that drifts, and square"


def rows(content):
    return turned(content, 95, 1)
