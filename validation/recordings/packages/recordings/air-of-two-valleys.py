"""How warm a valley of the upper Lahn is over how warm the lower one is, four years of days."""

from durations import DAY, YEAR
from models.cycles import tone
from models.fitting import line, scaled
from models.lags import usual_and_shifts
from readers.hydpy import valley

HAND_BUILT = "line"


def rows(*contents):
    return valley(*contents, first=5174, days=1461, names=("below_degc", "above_degc"))


def models(c):
    y, x, t = c["above_degc"], c["below_degc"], c["time_s"]
    u, w = scaled(x), scaled(t)
    return y, {
        **usual_and_shifts(y, x, t, DAY),
        "cube": line(y, x, u**2, u**3),
        "year": line(y, x, *tone(t, YEAR)),
        "year, two waves": line(y, x, *tone(t, YEAR), *tone(t, YEAR / 2)),
        "year, and drift": line(y, x, *tone(t, YEAR), w),
        "year, and square": line(y, x, *tone(t, YEAR), u**2),
        "drift, and slope that drifts": line(y, x, w, u * w),
    }
