"""Force on a plate after a jumper has left it, 8 s, every eighth reading. Nothing is on it."""

import numpy as np
from models.cycles import tone
from models.fitting import line
from readers.jumpmetrics import force_plates

HAND_BUILT = "constant"


def rows(content):
    force = force_plates(content)[24000::8, 2]
    return {"time_s": np.arange(len(force)) / 250, "plate_n": force}


def models(c):
    y, t = c["plate_n"], c["time_s"]
    return y, {HAND_BUILT: line(y), "drift": line(y, t), "mains": line(y, *tone(t, 1 / 50)), "mains of 60 Hz": line(y, *tone(t, 1 / 60))}
