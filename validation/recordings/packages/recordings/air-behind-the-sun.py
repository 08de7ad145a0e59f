"""Warmth of the air on a roof over the sun that shines on it, each minute of a clear day and its nights."""

from durations import DAY
from models.cycles import tone
from models.fitting import line, scaled, terms
from models.lags import lag, moved, usual
from readers.cpvlib import sunny_station

HAND_BUILT = "two waves a day alone"


def rows(content):
    return sunny_station(content, sun_w_m2="Gh", air_degc="Temp. Ai 1")


def models(c):
    y, x, t = c["air_degc"], c["sun_w_m2"], c["time_s"]
    late, v, one, two = lambda p: lag(x, t, abs(p) * 3600), scaled(t), tone(t, DAY), [*tone(t, DAY), *tone(t, DAY / 2)]
    return y, {
        **usual(y, x, t, 3600),
        "line, and lag": terms(y, lambda p: [x, late(p[0])], [4.0]),
        "lag, and square": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [4.0]),
        "lag, and drift": terms(y, lambda p: [late(p[0]), v], [4.0]),
        "lag, and shift": terms(y, lambda p: [moved(late(p[0]), t, p[1] * 3600)], [4.0, 0.1]),
        "lag of a lag": terms(y, lambda p: [lag(late(p[0]), t, abs(p[1]) * 3600)], [4.0, 0.3]),
        "two lags": terms(y, lambda p: [late(p[0]), late(p[1])], [4.0, 0.5]),
        "one wave a day": line(y, x, *one),
        "two waves a day": line(y, x, *two),
        "two waves a day alone": line(y, *two),
        "one wave a day, and lag": terms(y, lambda p: [late(p[0]), *one], [4.0]),
        "two waves a day, and lag": terms(y, lambda p: [late(p[0]), *two], [4.0]),
        "two waves a day, and drift": line(y, x, v, *two),
    }
