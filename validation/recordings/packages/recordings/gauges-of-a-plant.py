"""One instrument of a plant over another beside it, eleven days. One goes with the day, and on the eighth it comes to tell more."""

from fitting import lag, line, scaled, terms
from needles import days, plant
from pickups import clocks

HAND_BUILT = "day, and step"


def rows(content):
    return plant(content, first="tag26", second="tag31")


def models(c):
    y, x, t = c["second"], c["first"], c["time_s"]
    u, w = scaled(x), scaled(t)
    return y, {
        **clocks(y, x, t, 300),
        "cube": line(y, x, u**2, u**3),
        "drift, and its square": line(y, x, w, w**2),
        "line, and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 1800)], [2.0]),
        **days(y, x, t),
    }
