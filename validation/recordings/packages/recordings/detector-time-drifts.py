"""Time of a detector of cosmic rays against its neighbour, a day each, eleven years. It drifts."""

from functools import partial

from readers.hisparc_sapphire import detector
from readers.hisparc_sapphire import detector_models as models

HAND_BUILT = "drift, and its square"
rows = partial(detector, begin=1)
