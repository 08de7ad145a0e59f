"""Two inputs for current of a logger in series, through steps at which the inputs switch between a small and a large range. The zero of one is another in the large one."""

import numpy as np
from models.fitting import terms
from models.jumps import soft_step
from readers.rocketlogger import alike_models, side_by_side

HAND_BUILT = "another zero in the large range"
LABELS = ("first_ma", "second_ma")


def rows(content):
    return side_by_side(content, "I1H", "I2H", 1e-3, LABELS)


def models(c):
    y, x, t = c["second_ma"], c["first_ma"], c["time_s"]
    large = lambda p: soft_step(np.abs(x), p, 0.05)
    return y, {
        **alike_models(y, x, t),
        "another zero in the large range": terms(y, lambda p: [x, large(p[0])], [2.0]),
        "zero and slope of the large range": terms(y, lambda p: [x, large(p[0]), large(p[0]) * x], [2.0]),
        "another zero in either large range": terms(y, lambda p: [x, soft_step(x, p[0], 0.05), soft_step(-x, p[1], 0.05)], [2.0, 2.0]),
    }
