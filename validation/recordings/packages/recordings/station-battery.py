"""Battery voltage of a neutron probe that a solar panel charges, 15 min, forty days. No column tells of the sun."""

from models.cycles import tone
from models.fitting import line
from readers.neptoon import neutron_station

HAND_BUILT = "hours of the day"


def rows(content):
    frame = neutron_station(content)
    return {"time_s": frame.time_s, "box_c": frame.T1, "battery_v": frame.Vb}


def models(c):
    y, t, box = c["battery_v"], c["time_s"], c["box_c"]
    hours = [*tone(t, 86400), *tone(t, 43200)]
    return y, {
        "constant": line(y),
        "temperature": line(y, box),
        "drift": line(y, t),
        HAND_BUILT: line(y, *hours),
        "temperature and hours of the day": line(y, box, *hours),
    }
