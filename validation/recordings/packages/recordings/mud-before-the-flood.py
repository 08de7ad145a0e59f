"""How turbid a river is over how much of it flows, during a storm. The mud comes five hours before the flood."""

from fitting import lag, line, moved, scaled, terms
from levels import behind
from needles import storm
from pickups import clocks

HAND_BUILT = "shift ahead"


def rows(*contents):
    return storm(*contents, number=86)


def models(c):
    y, x, t = c["turbidity_fnu"], c["flow_m3_s"], c["time_s"]
    u, w, hour = scaled(x), scaled(t), 3600
    return y, {
        **clocks(y, x, t, 4 * hour),
        "cube": line(y, x, u**2, u**3),
        "drift, and slope that drifts": line(y, x, w, u * w),
        "square, and drift": line(y, x, u**2, w),
        "square, drift, and slope that drifts": line(y, x, u**2, w, u * w),
        **behind(y, x, t, 3 * hour),
        "line, lag, and square": terms(y, lambda p: [x, u**2, lag(x, t, abs(p[0]) * 3 * hour)], [1.0]),
        "line, lag, and drift": terms(y, lambda p: [x, w, lag(x, t, abs(p[0]) * 3 * hour)], [1.0]),
        "line, lag, and slope that drifts": terms(y, lambda p: [x, w, u * w, lag(x, t, abs(p[0]) * 3 * hour)], [1.0]),
        "line, lag, and shift": terms(y, lambda p: [moved(x, t, p[1] * hour), lag(moved(x, t, p[1] * hour), t, abs(p[0]) * 3 * hour)], [1.0, -0.3]),
    }
