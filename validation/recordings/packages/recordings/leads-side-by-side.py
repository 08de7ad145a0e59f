"""The fifth lead on the chest of a person over the sixth, which is a hand's breadth away, 10 seconds of a heart."""

from models.drifts import usual_shifts_and_drifts
from readers.pydicom import leads

HAND_BUILT = "line"


def rows(content):
    return leads(content, 5, v6_uv="V6", v5_uv="V5")


def models(c):
    return c["v5_uv"], usual_shifts_and_drifts(c["v5_uv"], c["v6_uv"], c["time_s"], 0.01)
