"""How high a marker on a heel is over how high that on the ankle is, beside the toe: a quick walk."""

from readers.gaitkit import foot
from readers.gaitkit import foot_models as models

HAND_BUILT = "all squares of toe, and drift"


def rows(content):
    return foot(content, "right", 1)
