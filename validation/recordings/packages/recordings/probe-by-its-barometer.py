"""How deep a pole is in snow as its barometer tells, over how its accelerometer tells it, as the package stores both; a push of 3 seconds."""

from readers.study_lyte import depth_models as models
from readers.study_lyte import push

HAND_BUILT = "drift, and square"


def rows(content):
    told = push(content, 20)
    return {"time_s": told["time"], "push_cm": told["acc_depth"], "barometer_cm": told["depth"]}
