"""How high waves run up the beach of Duck over how high they are, 138 times of one autumn. They run higher where it is steep, and when they are long."""

from models.drivers import gains, of_drivers, two_drivers
from models.fitting import line, scaled
from readers.py_wave_runup import runup

HAND_BUILT = "period and slope, slope by the first"


def rows(content):
    return runup(content, "DELILAH")


def models(c):
    y, x, drivers = c["runup_m"], c["height_m"], {"period": c["period_s"], "slope": c["slope"]}
    u, (period, slope) = scaled(x), (scaled(values) for values in drivers.values())
    return y, {
        **of_drivers(y, x, **drivers),
        **two_drivers(y, x, **drivers),
        **gains(y, x, **drivers),
        "period and slope, and square": line(y, x, u**2, period, slope),
        "root of height and length": line(y, x**0.5 * drivers["period"]),
        "root of height and length, and slope by it": line(y, x**0.5 * drivers["period"], x**0.5 * drivers["period"] * drivers["slope"]),
    }
