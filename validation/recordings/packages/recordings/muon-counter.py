"""Muons that a counter counts in an hour, 110 days of a winter, beside pressure and temperature of the air."""

from models.fitting import line, terms
from models.lags import lag
from readers.neptoon import muon_counter

HAND_BUILT = "pressure, temperature and drift"


def rows(content):
    frame = muon_counter(content)
    return {"time_s": frame.time_s, "muons": frame.muons, "pressure_hpa": frame.pressure, "air_c": frame.outside}


def models(c):
    y, p, air, t = c["muons"], c["pressure_hpa"], c["air_c"], c["time_s"]
    return y, {
        "constant": line(y),
        "pressure": line(y, p),
        "temperature": line(y, air),
        "drift": line(y, t),
        "pressure and temperature": line(y, p, air),
        "pressure and drift": line(y, p, t),
        HAND_BUILT: line(y, p, air, t),
        "late temperature": terms(y, lambda q: [lag(air, t, abs(q[0]) * 86400)], [3.0]),
        "pressure and late temperature": terms(y, lambda q: [p, lag(air, t, abs(q[0]) * 86400)], [3.0]),
    }
