"""Temperature of soil at the third rod of a probe over that at its first rod, nearer to the surface, three weeks of spring, a row each half hour. Heat arrives late and weakened."""

from models.fitting import terms
from models.lags import lag, usual
from readers.soil_heat import half_hours

HAND_BUILT = "line and lag"


def rows(content):
    frame = half_hours(content, "T_1_1_1", "T_1_3_1")
    return {"time_s": frame.time_s, "upper_c": frame.T_1_1_1, "lower_c": frame.T_1_3_1}


def models(c):
    y, x, t = c["lower_c"], c["upper_c"], c["time_s"]
    late = lambda p: lag(x, t, abs(p) * 3600)
    return y, {
        **usual(y, x, t, 3600),
        HAND_BUILT: terms(y, lambda p: [x, late(p[0])], [5.0]),
        "lag, and drift": terms(y, lambda p: [late(p[0]), t], [5.0]),
        "bent lag": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [5.0]),
        "two lags": terms(y, lambda p: [lag(late(p[0]), t, abs(p[1]) * 3600)], [5.0, 1.0]),
    }
