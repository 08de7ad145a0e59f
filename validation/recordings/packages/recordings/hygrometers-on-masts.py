"""Humidity of the air by one hygrometer over that by another of its kind, each beside a sonic anemometer, an hour at midnight, each second. Next to nothing is missing."""

from models.lags import late_models
from readers.eddycovtools import two_stations

HAND_BUILT = "lag, drift, and its square"


def rows(slow, sonic):
    frame = two_stations(slow, sonic)
    return {"time_s": frame.time_s, "first_pct": frame.RH1, "second_pct": frame.RH2}


def models(c):
    return c["second_pct"], late_models(c["second_pct"], c["first_pct"], c["time_s"], 30)
