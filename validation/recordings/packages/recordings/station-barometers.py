"""Two barometers in the box of a neutron probe, 15 min, forty days of spring. The first follows the temperature of the box."""

from models.fitting import line
from readers.neptoon import neutron_station

HAND_BUILT = "temperature, bent"


def rows(content):
    frame = neutron_station(content)
    return {"time_s": frame.time_s, "second_hpa": frame.P4, "first_hpa": frame.P1, "box_c": frame.T1}


def models(c):
    y, x, t, box = c["first_hpa"], c["second_hpa"], c["time_s"], c["box_c"]
    return y, {
        "line": line(y, x),
        "drift": line(y, x, t),
        "temperature": line(y, x, box),
        HAND_BUILT: line(y, x, box, box**2),
        "temperature and drift": line(y, x, box, t),
        "square": line(y, x, x**2),
    }
