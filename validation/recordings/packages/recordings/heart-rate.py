"""Heart rate by a strap over the power on the pedals, a ride in hills, means of five points. The heart follows within a minute, and less where it beats fast already."""

from formats.rows import means
from models.fitting import terms
from models.lags import lag, usual
from readers.sweat import trackpoints

HAND_BUILT = "lag, square, and drift"


def rows(content):
    frame = trackpoints(content)
    return {"time_s": means(frame.time_s, 5), "power_w": means(frame.watts, 5), "heart_per_min": means(frame.heart, 5)}


def models(c):
    y, x, t = c["heart_per_min"], c["power_w"], c["time_s"]
    return y, {
        **usual(y, x, t),
        "lag, square": terms(y, lambda p: [lag(x, t, abs(p[0]) * 60), lag(x, t, abs(p[0]) * 60) ** 2], [1.0]),
        "lag, and drift": terms(y, lambda p: [lag(x, t, abs(p[0]) * 60), t], [1.0]),
        HAND_BUILT: terms(y, lambda p: [lag(x, t, abs(p[0]) * 60), lag(x, t, abs(p[0]) * 60) ** 2, t], [1.0]),
        "square, then lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 60), lag(x**2, t, abs(p[0]) * 60)], [1.0]),
    }
