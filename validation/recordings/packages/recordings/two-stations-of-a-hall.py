"""When radio of one station comes in over when that of another does, in m, beside how strong both are. A receiver in a room, a minute and a half."""

from readers.pnt_datasets import pair
from readers.pnt_datasets import pair_models as models

HAND_BUILT = "first power and second power, slope by the second"


def rows(content):
    return pair(content, 2, 3)
