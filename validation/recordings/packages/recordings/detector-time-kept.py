"""Time of a detector of cosmic rays against its neighbour, a day each, four years. Nothing is missing."""

from probes import detector as rows
from probes import detector_models as models

HAND_BUILT = "drift, and its square"
