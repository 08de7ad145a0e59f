"""Acceleration of a body by a sensor on it, over the force of the platform from which it jumps, read by another hub, eight seconds. One hub is behind the other."""

from models.fitting import terms
from models.lags import lag, moved, usual_and_lags
from readers.biosignalsnotebooks import hubs, seconds_at

HAND_BUILT = "shift"


def rows(content):
    columns = list(hubs(content).values())
    force, upward = sum(columns[:4])[8000:12000], columns[5][8000:12000]
    return {"time_s": seconds_at(force, 500), "force_count": force, "upward_count": upward}


def models(c):
    y, x, t = c["upward_count"], c["force_count"], c["time_s"]
    return y, {
        **usual_and_lags(y, x, t, 0.2),
        "shift, and square": terms(y, lambda p: [moved(x, t, p[0] * 0.2), moved(x, t, p[0] * 0.2) ** 2], [0.7]),
        "shift, then lag": terms(y, lambda p: [lag(moved(x, t, p[0] * 0.2), t, abs(p[1]) * 0.2)], [0.7, 0.05]),
    }
