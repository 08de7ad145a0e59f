"""Temperature of the air by a thermometer in a shield over that by a sonic anemometer beside it, an hour at midnight, each second. The shield is late."""

from models.lags import late_models
from readers.eddycovtools import two_stations

HAND_BUILT = "lag, and drift"


def rows(slow, sonic):
    frame = two_stations(slow, sonic)
    return {"time_s": frame.time_s, "sonic_c": frame.sonic1_c, "air_c": frame.AirTC1}


def models(c):
    return c["air_c"], late_models(c["air_c"], c["sonic_c"], c["time_s"], 60)
