"""Temperature of the air at the second height of a mast in a beech forest over that at its first, six weeks of spring, a row each half hour, with net radiation. At night the one is colder than the other, by day warmer."""

import numpy as np
from models.cycles import tone
from models.fitting import line, terms
from models.lags import lag, usual
from readers.hesseflux import tower

HAND_BUILT = "net radiation, bent, and shift"


def rows(content):
    frame = tower(content, "2016-05-01", "2016-06-10", "TA_1_1_1", "TA_1_2_1", "NETRAD_1_1_1")
    return {"time_s": frame.time_s, "net_w_m2": frame.NETRAD_1_1_1, "first_c": frame.TA_1_1_1, "second_c": frame.TA_1_2_1}


def models(c):
    y, x, t, net = c["second_c"], c["first_c"], c["time_s"], c["net_w_m2"]
    at = lambda p: np.interp(t - p * 3600, t, x)
    return y, {
        **usual(y, x, t, 3600),
        "net radiation": line(y, x, net),
        "net radiation, bent": line(y, x, net, net**2),
        "late net radiation": terms(y, lambda p: [x, lag(net, t, abs(p[0]) * 3600)], [0.5]),
        "day": line(y, x, *tone(t, 86400)),
        HAND_BUILT: terms(y, lambda p: [at(p[0]), net, net**2], [-0.1]),
    }
