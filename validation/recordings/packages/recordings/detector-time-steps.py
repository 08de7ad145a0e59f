"""Time of a detector of cosmic rays against its neighbour, a day each, eleven years. It steps by 15 ns, and drifts before and after."""

from readers.hisparc_sapphire import detector as rows
from readers.hisparc_sapphire import detector_models as models

HAND_BUILT = "step, and a drift before and after"
