"""Temperature of a long cable by which a radio receiver is calibrated over that of the room, a row each half minute, four hours. It follows the room late."""

from models.lags import late_models
from readers.edges_cal import load_thermistors

HAND_BUILT = "lag"


def rows(content):
    frame = load_thermistors(content)
    return {"time_s": frame.time_s, "room_c": frame.room_c, "load_c": frame.load_c}


def models(c):
    return c["load_c"], late_models(c["load_c"], c["room_c"], c["time_s"], 600)
