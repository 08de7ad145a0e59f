"""Neutrons that a tube counts in 15 min, forty days, beside the pressure of the air, which shields them."""

from models.fitting import line
from readers.neptoon import neutron_station

HAND_BUILT = "pressure"


def rows(content):
    frame = neutron_station(content)
    return {"time_s": frame.time_s, "counts": frame.N2, "pressure_hpa": frame.P4}


def models(c):
    y, p, t = c["counts"], c["pressure_hpa"], c["time_s"]
    return y, {
        "constant": line(y),
        HAND_BUILT: line(y, p),
        "pressure, bent": line(y, p, (p - 1000) ** 2),
        "drift": line(y, t),
        "pressure and drift": line(y, p, t),
    }
