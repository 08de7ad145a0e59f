"""What solar cells on one roof give over what those on another that faces the same way do, in the hours of a hundred days. From some day on the one gives more."""

import numpy as np
from models.cycles import usual_and_day
from models.fitting import line, scaled
from readers.citylearn import changed_at_best, roofs

HAND_BUILT = "slope that changes"


def rows(*contents):
    return roofs(*contents, begin=0, end=100, least=20)


def models(c):
    y, x, t = c["second_w_kw"], c["first_w_kw"], c["time_s"]
    u, w = scaled(x), scaled(t)
    return y, {**usual_and_day(y, x, t), "slope that drifts": line(y, x, u * w), "drift, and slope that drifts": line(y, x, w, u * w), **changed_at_best(y, x, t, np.arange(0.05, 0.96, 0.01))}
