"""Time of a detector of cosmic rays against its neighbour, a day each, four years. Nothing is missing."""

from readers.hisparc_sapphire import detector as rows
from readers.hisparc_sapphire import detector_models as models

HAND_BUILT = "drift, and its square"
