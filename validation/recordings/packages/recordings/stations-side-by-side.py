"""When radio of one station comes in over when that of the one across the hall does, in m, beside how strong both are. A receiver that is carried along, 23 minutes."""

from readers.pnt_datasets import pair
from readers.pnt_datasets import pair_models as models

HAND_BUILT = "line"


def rows(content):
    return pair(content, 3, 4)
