"""Time of a detector of cosmic rays against its neighbour, a day each, four years. It goes with the season."""

from functools import partial

from readers.hisparc_sapphire import detector
from readers.hisparc_sapphire import detector_models as models

HAND_BUILT = "year"
rows = partial(detector, begin=15)
