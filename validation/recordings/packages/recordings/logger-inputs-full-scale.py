"""Two voltage inputs of a logger while they are calibrated over their whole range, as numbers of the converter. One bends near the end of its range, and jumps there."""

import numpy as np
from models.fitting import terms
from models.jumps import soft_step
from readers.rocketlogger import alike_models, side_by_side

HAND_BUILT = "jump and bend near the end"
LABELS = ("first_kcounts", "second_kcounts")


def rows(content):
    return side_by_side(content, "V1", "V2", 1e3, LABELS)


def models(c):
    y, x, t = c["second_kcounts"], c["first_kcounts"], c["time_s"]
    jump = lambda p: soft_step(x, p[0] * 1000, abs(p[1]) * 100 + 1)
    bend = lambda p: np.maximum(0, p * 1000 - x)
    return y, {
        **alike_models(y, x, t),
        "jump near the end": terms(y, lambda p: [x, jump(p)], [-3.5, 0.5]),
        "jump and bend near the end": terms(y, lambda p: [x, jump(p), bend(p[2])], [-3.5, 0.5, -1.0]),
        "jump and soft bend near the end": terms(y, lambda p: [x, jump(p), bend(p[2]) ** 2], [-3.5, 0.5, -1.0]),
    }
