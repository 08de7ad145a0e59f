"""Warmth of a room over that outside, each hour of a week. Walls keep the room behind."""

from models.cycles import tone, usual_and_day
from models.fitting import line, terms
from models.lags import behind, lag, moved
from readers.cdt import pair_columns

HAND_BUILT = "lag"


def rows(content):
    return pair_columns(content, step=3600, outside_degc=("pair48", "A"), room_degc=("pair48", "B"))


def models(c):
    y, x, t = c["room_degc"], c["outside_degc"], c["time_s"]
    late, day = lambda p: lag(x, t, abs(p) * 36000), [*tone(t, 86400), *tone(t, 43200)]
    return y, {
        **{name: model for name, model in usual_and_day(y, x, t).items() if name != "lag"},
        "lag": terms(y, lambda p: [late(p[0])], [1.0]),
        **behind(y, x, t, 36000),
        "lag, and day": terms(y, lambda p: [late(p[0]), *day], [1.0]),
        "lag, and shift": terms(y, lambda p: [moved(late(p[0]), t, p[1] * 3600)], [1.0, 0.5]),
        "day alone": line(y, *day),
    }
