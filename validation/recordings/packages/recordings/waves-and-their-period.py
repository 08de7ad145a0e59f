"""How long waves last over how high they are, at a buoy off Maine, a year. Wind makes short waves at once, and what is left after it is long."""

import numpy as np
from durations import DAY, HOUR
from models.cycles import tone
from models.fitting import line, scaled, terms
from models.lags import behind, lag, usual_and_shifts
from readers.virocon import buoy

HAND_BUILT = "lag"


def rows(content):
    return buoy(content, 2)


def models(c):
    y, x, t = c["period_s"], c["height_m"], c["time_s"]
    u, w, unit, year = scaled(x), scaled(t), 3 * HOUR, 365.25 * DAY
    return y, {
        **usual_and_shifts(y, x, t, unit),
        "cube": line(y, x, u**2, u**3),
        "logarithm": line(y, np.log(x)),
        "day": line(y, x, *tone(t, DAY), *tone(t, DAY / 2)),
        "year": line(y, x, *tone(t, year), *tone(t, year / 2)),
        "drift, and slope that drifts": line(y, x, w, u * w),
        **behind(y, x, t, unit),
        "lag, and year": terms(y, lambda p: [lag(x, t, abs(p[0]) * unit), *tone(t, year)], [1.0]),
        "lag, and logarithm": terms(y, lambda p: [lag(x, t, abs(p[0]) * unit), np.log(x)], [1.0]),
    }
