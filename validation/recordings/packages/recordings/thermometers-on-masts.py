"""Temperature of the air by one thermometer over that by another of its kind, each beside a sonic anemometer, an hour at midnight, each second. One is behind the other."""

from models.lags import late_models
from readers.eddycovtools import two_stations

HAND_BUILT = "lag"


def rows(slow, sonic):
    frame = two_stations(slow, sonic)
    return {"time_s": frame.time_s, "first_c": frame.AirTC1, "second_c": frame.AirTC2}


def models(c):
    return c["second_c"], late_models(c["second_c"], c["first_c"], c["time_s"], 30)
