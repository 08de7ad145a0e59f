"""Voltage of the battery of a radio receiver in a desert over the current of its cooler, a row each five minutes, three days. Its cables and its cells resist."""

from models.cycles import tone
from models.fitting import line
from models.lags import usual
from readers.edges_io import field_receiver

HAND_BUILT = "line"


def rows(content):
    frame = field_receiver(content)
    return {"time_s": frame.time_s, "box_c": frame.box_c, "current_a": frame.current_a, "battery_v": frame.battery_v}


def models(c):
    y, x, t, warm = c["battery_v"], c["current_a"], c["time_s"], c["box_c"]
    return y, {
        **usual(y, x, t, 600),
        "temperature": line(y, x, warm),
        "gain by temperature": line(y, x, x * warm),
        "day": line(y, x, *tone(t, 86400)),
    }
