"""Water of the Lahn at Leun over that at Marburg, farther up, 300 days of a winter with floods."""

from fitting import line, moved, scaled, terms, tone
from levels import behind
from meters import DAY, YEAR
from pickups import clocks
from tellers import valley

HAND_BUILT = "shift"


def rows(*contents):
    return valley(*contents, first=1826, days=300, names=("above_m3_s", "below_m3_s"))


def models(c):
    y, x, t = c["below_m3_s"], c["above_m3_s"], c["time_s"]
    u, w = scaled(x), scaled(t)
    at = lambda p: moved(x, t, p * DAY)
    return y, {
        **clocks(y, x, t, DAY),
        "drift, and slope that drifts": line(y, x, w, u * w),
        "year": line(y, x, *tone(t, YEAR)),
        "shift, and year": terms(y, lambda p: [at(p[0]), *tone(t, YEAR)], [0.5]),
        "shift, and slope that drifts": terms(y, lambda p: [at(p[0]), w, w * at(p[0])], [0.5]),
        **behind(y, x, t, DAY),
    }
