"""Flow of a river over that at a gauge upstream, 3500 days from 2001 on, means of a day. Water needs half a day to come down."""

import numpy as np
from fitting import lag, terms, usual
from instruments import gauges

HAND_BUILT = "shift"


def rows(first, second):
    at, above, below = gauges(first, second, 0)
    return {"time_s": at, "above_ft3_s": above, "below_ft3_s": below}


def models(c):
    y, x, t = c["below_ft3_s"], c["above_ft3_s"], c["time_s"]
    shifted = lambda p: np.interp(t - p * 86400, t, x)
    return y, {
        **usual(y, x, t, 86400),
        "shift, and lag": terms(y, lambda p: [lag(shifted(p[0]), t, abs(p[1]) * 86400)], [0.5, 0.5]),
        "shift, and square": terms(y, lambda p: [shifted(p[0]), shifted(p[0]) ** 2], [0.5]),
        "line and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 86400)], [1.0]),
    }
