"""Third barometer of the same box beside the second one, 15 min, forty days. They agree; temperature takes a tenth of the small rest."""

from models.fitting import line
from readers.neptoon import neutron_station

HAND_BUILT = "temperature"


def rows(content):
    frame = neutron_station(content)
    return {"time_s": frame.time_s, "second_hpa": frame.P4, "third_hpa": frame.P3, "box_c": frame.T1}


def models(c):
    y, x, t, box = c["third_hpa"], c["second_hpa"], c["time_s"], c["box_c"]
    return y, {
        "line": line(y, x),
        "drift": line(y, x, t),
        HAND_BUILT: line(y, x, box),
        "temperature, bent": line(y, x, box, box**2),
        "temperature and drift": line(y, x, box, t),
    }
