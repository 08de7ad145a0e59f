"""Where a camera that is moved by hand takes itself to be, sideways, beside a room that follows it. They agree; a shift of their clocks takes a seventh of the small rest."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.evo import track

HAND_BUILT = "shift"


def rows(content, truth):
    seen, true = track(content), track(truth)
    seen = seen[(seen[:, 0] >= true[0, 0]) & (seen[:, 0] <= true[-1, 0])]
    return {"time_s": seen[:, 0] - seen[0, 0], "true_m": np.interp(seen[:, 0], true[:, 0], true[:, 2]), "camera_m": seen[:, 2]}


def models(c):
    y, x, t = c["camera_m"], c["true_m"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        HAND_BUILT: terms(y, lambda p: [np.interp(t - p[0] * 0.1, t, x)], [0.1]),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 0.1)], [0.3]),
        "line and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 0.1)], [1.0]),
    }
