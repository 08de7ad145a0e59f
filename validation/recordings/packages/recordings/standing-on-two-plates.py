"""Force under one foot over that under the other while a jumper stands before the jump, 4.75 s, every fourth reading. Together they are a weight."""

import numpy as np
from models.lags import usual
from readers.jumpmetrics import force_plates

HAND_BUILT = "line"


def rows(content):
    forces = force_plates(content)[6000:15500:4]
    return {"time_s": np.arange(len(forces)) / 500, "left_n": forces[:, 2], "right_n": forces[:, 8]}


def models(c):
    return c["right_n"], usual(c["right_n"], c["left_n"], c["time_s"], 0.1)
