"""Warmth of the air over the sun that shone, each day of ten years. What the sun warms keeps it for days and for months."""

from durations import DAY
from models.cycles import tone
from models.fitting import line, scaled, terms
from models.lags import behind, lag, moved
from readers.cdt import pair_columns

HAND_BUILT = "line, lag, and year"


def rows(content):
    return pair_columns(content, step=DAY, rows=3652, sun_wh_m2=("pair72", "A"), air_degc=("pair72", "B"))


def models(c):
    y, x, t = c["air_degc"], c["sun_wh_m2"], c["time_s"]
    u, w, year, late = scaled(x), scaled(t), tone(t, 365.2425 * DAY), lambda p: lag(x, t, abs(p) * 10 * DAY)
    return y, {
        "line": line(y, x),
        "square": line(y, x, u**2),
        "drift": line(y, x, w),
        "shift": terms(y, lambda p: [moved(x, t, p[0] * 10 * DAY)], [0.2]),
        "lag": terms(y, lambda p: [late(p[0])], [1.0]),
        **behind(y, x, t, 10 * DAY),
        "year": line(y, x, *year),
        "two waves a year": line(y, x, *year, *tone(t, 365.2425 * DAY / 2)),
        "year, and square": line(y, x, u**2, *year),
        "year, and drift": line(y, x, w, *year),
        "year, and slope by it": line(y, x, *year, *(u * part for part in year)),
        "year, and shift": terms(y, lambda p: [moved(x, t, p[0] * 10 * DAY), *year], [0.05]),
        "lag, and year": terms(y, lambda p: [late(p[0]), *year], [0.5]),
        "line, lag, and year": terms(y, lambda p: [x, late(p[0]), *year], [0.5]),
        "lag, year, and square": terms(y, lambda p: [late(p[0]), scaled(late(p[0])) ** 2, *year], [0.5]),
        "lag, year, and drift": terms(y, lambda p: [late(p[0]), *year, w], [0.5]),
        "year alone": line(y, *year),
    }
