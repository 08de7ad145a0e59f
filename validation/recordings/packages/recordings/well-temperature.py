"""Temperature of the water in a well, by the logger of its level, over that of the barometer beside it, 19 months, every fourth hour. What is above comes down late and weak."""

from formats.clock import seconds
from models.fitting import terms
from models.lags import lag, usual
from readers.gensor import wells

HAND_BUILT = "lag of a lag"


def rows(first, second, barometer):
    frame = wells(first, second, barometer).iloc[::4]
    return {"time_s": seconds(frame.when), "air_c": frame.degc, "water_c": frame.degc_2}


def models(c):
    y, x, t = c["water_c"], c["air_c"], c["time_s"]
    late = lambda p, u: lag(u, t, abs(p) * 1e6)
    return y, {
        **usual(y, x, t, 1e6),
        "lag, and drift": terms(y, lambda p: [late(p[0], x), t], [1.0]),
        "line and lag": terms(y, lambda p: [x, late(p[0], x)], [1.0]),
        HAND_BUILT: terms(y, lambda p: [late(p[0], late(p[0], x))], [1.0]),
    }
