"""Friction on the sleeve of a cone that is pushed into sand under the sea over the resistance of its tip, the first five metres. The sleeve comes later than the tip. A row counts as a second; rows follow depth, 0.02 m each."""

import numpy as np
from models.fitting import terms
from models.lags import lag, moved, usual_and_lags
from readers.groundhog import cone_test

HAND_BUILT = "shift, and drift"


def rows(content):
    found = cone_test(content, 5.0)
    return {"time_s": np.arange(len(found["depth_m"])), "tip_mpa": found["cone_mpa"], "sleeve_mpa": found["sleeve_mpa"]}


def models(c):
    y, x, t = c["sleeve_mpa"], c["tip_mpa"], c["time_s"]
    late = lambda p: moved(x, t, p * 5)
    return y, {
        **usual_and_lags(y, x, t, 5),
        "shift, and square": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [0.5]),
        "shift, and drift": terms(y, lambda p: [late(p[0]), t], [0.5]),
        "lag, square, and drift": terms(y, lambda p: [lag(x, t, abs(p[0]) * 5), lag(x, t, abs(p[0]) * 5) ** 2, t], [0.5]),
    }
