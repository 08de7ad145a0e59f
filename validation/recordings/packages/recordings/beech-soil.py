"""Temperature of the soil below a beech forest, the third depth of a profile over its first, six weeks of spring, a row each half hour. Heat arrives late and weakened."""

from models.fitting import terms
from models.lags import lag, usual
from readers.hesseflux import tower

HAND_BUILT = "bent lag"


def rows(content):
    frame = tower(content, "2016-04-01", "2016-05-15", "TS_6_1_1", "TS_6_3_1")
    return {"time_s": frame.time_s, "upper_c": frame.TS_6_1_1, "lower_c": frame.TS_6_3_1}


def models(c):
    y, x, t = c["lower_c"], c["upper_c"], c["time_s"]
    late = lambda p: lag(x, t, abs(p) * 3600)
    return y, {
        **usual(y, x, t, 3600),
        "line and lag": terms(y, lambda p: [x, late(p[0])], [20.0]),
        "lag, and drift": terms(y, lambda p: [late(p[0]), t], [20.0]),
        HAND_BUILT: terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [20.0]),
        "two lags": terms(y, lambda p: [lag(late(p[0]), t, abs(p[1]) * 3600)], [20.0, 3.0]),
    }
