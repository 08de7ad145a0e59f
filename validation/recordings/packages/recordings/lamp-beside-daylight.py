"""How much infrared light comes back to the tip of a pole that has a lamp, over how much daylight another sensor has, while the pole is pushed into snow."""

from models.drifts import usual_shifts_and_drifts
from models.drivers import drivers_and_drift, of_drivers
from readers.study_lyte import push

HAND_BUILT = "square, and depth"


def rows(content):
    told = push(content, 15)
    return {"time_s": told["time"], "daylight": told["Sensor2"], "depth_cm": told["depth"], "lamp": told["Sensor3"]}


def models(c):
    y, x, t, z = c["lamp"], c["daylight"], c["time_s"], c["depth_cm"]
    return y, {**usual_shifts_and_drifts(y, x, t, 0.02), **of_drivers(y, x, depth=z), **drivers_and_drift(y, x, t, depth=z)}
