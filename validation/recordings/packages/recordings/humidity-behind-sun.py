"""Humidity of air over how warm it is, the hours of five months from May on, and the sun. The ground gives back what it took up from the sun for hours."""

from durations import DAY, HOUR
from models.cycles import tone
from models.drivers import of_drivers
from models.fitting import line, terms
from models.lags import lag
from readers.mettoolbox import weather_hours

HAND_BUILT = "sun, late sun, and day"


def rows(content):
    return weather_hours(content, "2014-05", "2014-09")


def models(c):
    y, x, sun, t = c["humidity_percent"], c["air_degc"], c["sun_w_m2"], c["time_s"]
    late = lambda p: lag(sun, t, abs(p) * HOUR)
    return y, {
        **of_drivers(y, x, sun=sun),
        "drift": line(y, x, t),
        "day": line(y, x, *tone(t, DAY)),
        "sun, and day": line(y, x, sun, *tone(t, DAY)),
        "late sun": terms(y, lambda p: [x, late(p[0])], [1.0]),
        "sun, and late sun": terms(y, lambda p: [x, sun, late(p[0])], [1.0]),
        "late sun, and square": terms(y, lambda p: [x, x**2, late(p[0])], [1.0]),
        "late sun, and drift": terms(y, lambda p: [x, late(p[0]), t], [1.0]),
        "late sun, drift, and square": terms(y, lambda p: [x, x**2, late(p[0]), t], [1.0]),
        "sun, late sun, and drift": terms(y, lambda p: [x, sun, late(p[0]), t], [1.0]),
        "sun, late sun, and day": terms(y, lambda p: [x, sun, late(p[0]), *tone(t, DAY)], [1.0]),
        "late sun, and day": terms(y, lambda p: [x, late(p[0]), *tone(t, DAY)], [1.0]),
    }
