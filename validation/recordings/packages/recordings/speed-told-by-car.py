"""Speed that a car tells over the speed of the rollers below it, half an hour, a row a second. Nothing is missing."""

from models.lags import usual_and_lags
from readers.co2mpas import car_on_rollers

HAND_BUILT = "line"


def rows(content):
    frame = car_on_rollers(content)
    return {"time_s": frame.times, "rollers_kmh": frame.velocities, "told_kmh": frame.obd_velocities}


def models(c):
    return c["told_kmh"], usual_and_lags(c["told_kmh"], c["rollers_kmh"], c["time_s"], 1)
