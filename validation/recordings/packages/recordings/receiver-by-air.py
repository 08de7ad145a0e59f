"""Temperature of a radio receiver that a thermostat holds over that of the air outside, in a desert, a row each five minutes, three and a half days. It follows the air late."""

from models.lags import late_models
from readers.edges_io import hut

HAND_BUILT = "two lags"


def rows(content):
    frame = hut(content)
    return {"time_s": frame.time_s, "air_c": frame.air_c, "receiver_c": frame.receiver_c}


def models(c):
    return c["receiver_c"], late_models(c["receiver_c"], c["air_c"], c["time_s"], 3600)
