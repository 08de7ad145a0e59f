"""Pressure at sea level that a weather station gives over that at its place, 80 m higher, 15 days, each ten minutes. Warm air is thin: the column below weighs less."""

from formats.clock import seconds
from models.fitting import line
from models.lags import usual
from readers.metobs_toolkit import weather_station

HAND_BUILT = "temperature"


def rows(content):
    frame = weather_station(content, "vlinder17").iloc[::2].dropna(subset=["Temperatuur", "Luchtdruk", "Luchtdruk_Zeeniveau"])
    at = seconds(frame.index)
    return {"time_s": at, "station_hpa": frame.Luchtdruk / 100, "air_c": frame.Temperatuur, "sea_level_hpa": frame.Luchtdruk_Zeeniveau / 100}


def models(c):
    y, x, t, degrees = c["sea_level_hpa"], c["station_hpa"], c["time_s"], c["air_c"]
    return y, {**usual(y, x, t, 600), HAND_BUILT: line(y, x, degrees), "temperature, and its product": line(y, x, degrees, degrees * x), "temperature, and drift": line(y, x, degrees, t)}
