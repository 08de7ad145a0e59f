"""Moisture of soil under rain: a bucket that leaks. No model of rain and air temperature beat the line on rows left out."""

import pandas as pd
from formats.clock import seconds
from models.fitting import line, terms
from models.lags import lag

HAND_BUILT = "line"


def lines(content, columns):
    split = [line.split(",")[: len(columns)] for line in content.decode().splitlines() if line[:2] == "20"]
    return pd.DataFrame(split, columns=columns)


def rows(moisture, weather):
    d = lines(moisture, ["time", "m10"]).merge(lines(weather, ["time", "rain", "p", "sol", "rh", "air", "wind", "gw"]), on="time")
    t = pd.to_datetime(d.time)
    d = d.drop(columns="time").apply(pd.to_numeric, errors="coerce").assign(t=t)
    d = d[(d.t >= "2015-05-01") & (d.t < "2015-10-01")].dropna()
    return {"time_s": seconds(d.t), "rain_mm_per_day": d.rain, "air_c": d.air, "soil_moisture": d.m10 * 100}


def models(c):
    y, t, rain = c["soil_moisture"], c["time_s"], c["rain_mm_per_day"]
    return y, {HAND_BUILT: line(y, rain), "one lag": terms(y, lambda p: [lag(rain, t, abs(p[0]))], [4e5])}
