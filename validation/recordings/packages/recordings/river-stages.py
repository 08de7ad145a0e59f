"""Water level of a river over that at a gauge upstream, 3500 days from 2001 on, means of a day. Water needs half a day to come down, and a part of it weeks."""

import numpy as np
from models.cycles import tone
from models.fitting import line, terms
from models.lags import lag
from readers.tstoolbox import river_gauges, river_models

HAND_BUILT = "shift, and a slow part"


def rows(first, second):
    at, above, below = river_gauges(first, second, 1)
    return {"time_s": at, "above_ft": above, "below_ft": below}


def models(c):
    y, x, t = c["below_ft"], c["above_ft"], c["time_s"]
    shifted = lambda p: np.interp(t - p * 86400, t, x)
    return y, {
        **river_models(y, x, t),
        "year": line(y, x, *tone(t, 365.25 * 86400)),
        "shift, and year": terms(y, lambda p: [shifted(p[0]), *tone(t, 365.25 * 86400)], [0.5]),
        "two lags": terms(y, lambda p: [lag(x, t, abs(p[0]) * 86400), lag(x, t, abs(p[1]) * 86400)], [0.5, 40.0]),
        HAND_BUILT: terms(y, lambda p: [shifted(p[0]), lag(x, t, abs(p[1]) * 86400)], [0.5, 40.0]),
    }
