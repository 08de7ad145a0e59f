"""Weight of what is left of PMMA on a thermobalance from 480 degC on, while it is heated, every second reading. Next to nothing burns any more; gas carries a little less, or a little of it goes."""

from fitting import line
from rigs import balance, since

HAND_BUILT = "drift"


def rows(content):
    frame = balance(content)
    frame = frame[frame.sample_c > 480]
    return {"time_s": since(frame.time_s), "sample_c": frame.sample_c, "weight_ug": frame.weight_mg * 1000}


def models(c):
    y, x, t = c["weight_ug"], c["sample_c"], c["time_s"]
    return y, {"constant": line(y), HAND_BUILT: line(y, t), "temperature": line(y, x), "temperature, bent": line(y, x, x**2)}
