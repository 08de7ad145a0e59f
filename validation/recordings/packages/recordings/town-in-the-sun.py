"""How warm the air of London is over the sun, 40 days of early summer. Roofs and streets are warmed first, and summer comes."""

from durations import HOUR
from models.cycles import waves_of_day
from models.fitting import line, scaled, terms
from models.lags import behind, lag, usual_and_shifts
from readers.supy import town

HAND_BUILT = "lag, and drift"


def rows(content):
    return town(content, 3600, 960, sun_w_m2="kdown", air_degc="Tair")


def models(c):
    y, x, t = c["air_degc"], c["sun_w_m2"], c["time_s"]
    u, w, late = scaled(x), scaled(t), lambda p: lag(x, t, abs(p) * 3 * HOUR)
    return y, {
        **usual_and_shifts(y, x, t, 3 * HOUR),
        "cube": line(y, x, u**2, u**3),
        "drift, and its square": line(y, x, w, w**2),
        "drift, and slope that drifts": line(y, x, w, u * w),
        **behind(y, x, t, 3 * HOUR),
        "lag, drift, and its square": terms(y, lambda p: [late(p[0]), w, w**2], [1.0]),
        "lag, drift, and square": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2, w], [1.0]),
        "two lags, and drift": terms(y, lambda p: [late(p[0]), late(p[1]), w], [0.5, 20.0]),
        **waves_of_day(y, x, t),
    }
