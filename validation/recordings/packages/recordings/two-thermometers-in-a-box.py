"""A thermometer for the air in a box of sensors over the one of its inertial sensor, three and a half days."""

from durations import DAY
from models.cycles import tone
from models.drifts import usual_shifts_and_drifts
from models.fitting import line, scaled, terms
from models.lags import lag
from readers.sp00kyvectors import sensor_box

HAND_BUILT = "line, lag, and drift"


def rows(content):
    return sensor_box(content, "2025-05-0[6-9]", inertial_degc="Temp_LSM9DS1", air_degc="BME680_Temp")


def models(c):
    y, x, t = c["air_degc"], c["inertial_degc"], c["time_s"]
    w = scaled(t)
    return y, {
        **usual_shifts_and_drifts(y, x, t, 600),
        "line, and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 600)], [1.0]),
        "line, lag, and drift": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 600), w], [1.0]),
        "day": line(y, x, *tone(t, DAY)),
        "drift, and day": line(y, x, w, *tone(t, DAY)),
    }
