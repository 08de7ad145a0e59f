"""Weight of PMMA on a thermobalance over that of a first piece, heated in the same way, every second reading. They go alike."""

from formats.clock import since_first
from models.lags import usual
from readers.firescipy import thermobalance

HAND_BUILT = "drift"


def rows(first, second):
    one, two = thermobalance(first).iloc[::2], thermobalance(second).iloc[::2]
    return {"time_s": since_first(one.time_s), "first_mg": one.weight_mg, "second_mg": two.weight_mg}


def models(c):
    return c["second_mg"], usual(c["second_mg"], c["first_mg"], c["time_s"], 10)
