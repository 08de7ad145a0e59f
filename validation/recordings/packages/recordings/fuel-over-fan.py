"""Fuel that a jet engine burns over the speed of its fan, in flight. Where the air is thin, the same speed takes less; and fuel grows as a power of the speed."""

from models.drivers import of_drivers
from models.fitting import line, scaled
from models.lags import usual_and_shifts
from readers.openap import flight

HAND_BUILT = "square, and slope by height"


def rows(content):
    return flight(content, 60, 3, {"fuel_kg_h": 3600}, fan_percent="n1_l", height_ft="alt", fuel_kg_h="ff_l")


def models(c):
    y, x, t, height = c["fuel_kg_h"], c["fan_percent"], c["time_s"], c["height_ft"]
    u, v, w = scaled(x), scaled(height), scaled(t)
    return y, {
        **of_drivers(y, x, height=height),
        **{name: model for name, model in usual_and_shifts(y, x, t, 3).items() if name in ("drift", "shift", "lag")},
        "slope by height alone": line(y, x, u * v),
        "square, and slope by height alone": line(y, x, u**2, u * v),
        "cube, and height": line(y, x, u**2, u**3, v),
        "cube, and slope by height": line(y, x, u**2, u**3, v, u * v),
        "square, slope by height, and drift": line(y, x, u**2, v, u * v, w),
        "square, slope by height, and all cubes": line(y, x, u**2, u**3, v, u * v, v**2, u**2 * v, u * v**2),
    }
