"""Two thermometers of one CTD, the first 820 rows: one comes later by some 0.03 s, as a small share of a lagged copy."""

from models.fitting import line, terms
from models.lags import lag
from readers.cotede import ctd_cast

HAND_BUILT = "a share that comes later"


def rows(content):
    d = ctd_cast(content, 820)
    return {"time_s": d.timeS.round(3), "second_thermometer": d.TEMP2, "depth": d.PRES, "first_thermometer": d.TEMP}


def models(c):
    y, x, t = c["first_thermometer"], c["second_thermometer"], c["time_s"]
    return y, {"line": line(y, x), HAND_BUILT: terms(y, lambda p: [x, lag(x, t, abs(p[0]))], [2.0])}
