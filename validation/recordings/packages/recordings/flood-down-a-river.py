"""Water of the Lahn at Leun over that at Marburg, farther up, 300 days of a winter with floods."""

from durations import DAY, YEAR
from models.cycles import tone
from models.fitting import line, scaled, terms
from models.lags import behind, moved, usual_and_shifts
from readers.hydpy import valley

HAND_BUILT = "shift"


def rows(*contents):
    return valley(*contents, first=1826, days=300, names=("above_m3_s", "below_m3_s"))


def models(c):
    y, x, t = c["below_m3_s"], c["above_m3_s"], c["time_s"]
    u, w = scaled(x), scaled(t)
    at = lambda p: moved(x, t, p * DAY)
    return y, {
        **usual_and_shifts(y, x, t, DAY),
        "drift, and slope that drifts": line(y, x, w, u * w),
        "year": line(y, x, *tone(t, YEAR)),
        "shift, and year": terms(y, lambda p: [at(p[0]), *tone(t, YEAR)], [0.5]),
        "shift, and slope that drifts": terms(y, lambda p: [at(p[0]), w, w * at(p[0])], [0.5]),
        **behind(y, x, t, DAY),
    }
