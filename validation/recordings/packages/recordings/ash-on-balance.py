"""Weight of what is left of PMMA on a thermobalance from 480 degC on, while it is heated, every second reading. Next to nothing burns any more; gas carries a little less, or a little of it goes."""

from formats.clock import since_first
from models.fitting import line
from readers.firescipy import thermobalance

HAND_BUILT = "drift"


def rows(content):
    frame = thermobalance(content)
    frame = frame[frame.sample_c > 480]
    return {"time_s": since_first(frame.time_s), "sample_c": frame.sample_c, "weight_ug": frame.weight_mg * 1000}


def models(c):
    y, x, t = c["weight_ug"], c["sample_c"], c["time_s"]
    return y, {"constant": line(y), HAND_BUILT: line(y, t), "temperature": line(y, x), "temperature, bent": line(y, x, x**2)}
