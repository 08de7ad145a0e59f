"""Neutrons that the other tube counts in 15 min over the pressure of the air, forty days. What is left is the noise of counting."""

from models.cycles import tone
from models.fitting import line
from readers.neptoon import neutron_station

HAND_BUILT = "line"


def rows(content):
    frame = neutron_station(content)
    return {"time_s": frame.time_s, "counts": frame.N1, "pressure_hpa": frame.P4, "air_c": frame.TCS}


def models(c):
    y, p, t, air = c["counts"], c["pressure_hpa"], c["time_s"], c["air_c"]
    return y, {
        HAND_BUILT: line(y, p),
        "square": line(y, p, (p - 1000) ** 2),
        "drift": line(y, p, t),
        "temperature": line(y, p, air),
        "hours of the day": line(y, p, *tone(t, 86400)),
    }
