"""How high a marker on a heel is over how high that on the ankle is, beside the toe: a slow walk with Parkinson's disease."""

from readers.gaitkit import foot
from readers.gaitkit import foot_models as models

HAND_BUILT = "toe"


def rows(content):
    return foot(content, "left", 1)
