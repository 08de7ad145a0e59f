"""Temperature of a rack of electronics over that of the air outside, in a desert, a row each five minutes, three and a half days. It follows the air late."""

from models.lags import late_models
from readers.edges_io import hut

HAND_BUILT = "lag, and drift"


def rows(content):
    frame = hut(content)
    return {"time_s": frame.time_s, "air_c": frame.air_c, "rack_c": frame.rack_c}


def models(c):
    return c["rack_c"], late_models(c["rack_c"], c["air_c"], c["time_s"], 7200)
