"""Temperature of the air by one sonic anemometer over that by another of its kind, an hour at midnight, means of a second. Next to nothing is missing."""

from models.lags import late_models
from readers.eddycovtools import two_stations

HAND_BUILT = "square"


def rows(slow, sonic):
    frame = two_stations(slow, sonic)
    return {"time_s": frame.time_s, "first_c": frame.sonic1_c, "second_c": frame.sonic2_c}


def models(c):
    return c["second_c"], late_models(c["second_c"], c["first_c"], c["time_s"], 10)
