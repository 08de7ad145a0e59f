"""Force on a plate after a jumper has left it, 8 s, every eighth reading. Nothing is on it."""

import numpy as np
from fitting import line, tone
from rigs import plates

HAND_BUILT = "constant"


def rows(content):
    force = plates(content)[24000::8, 2]
    return {"time_s": np.arange(len(force)) / 250, "plate_n": force}


def models(c):
    y, t = c["plate_n"], c["time_s"]
    return y, {HAND_BUILT: line(y), "drift": line(y, t), "mains": line(y, *tone(t, 1 / 50)), "mains of 60 Hz": line(y, *tone(t, 1 / 60))}
