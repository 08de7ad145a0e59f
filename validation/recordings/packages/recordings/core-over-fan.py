"""Speed of the core of a jet engine over that of its fan, in flight. The two do not go in step, and where the air is cold both turn slower for the same thrust."""

from models.drivers import of_drivers
from models.fitting import line, scaled
from models.lags import usual_and_shifts
from readers.openap import flight

HAND_BUILT = "cube, and warmth"


def rows(content):
    return flight(content, 60, 3, fan_percent="n1_r", core_percent="n2_r", air_degc="sat")


def models(c):
    y, x, t, warmth = c["core_percent"], c["fan_percent"], c["time_s"], c["air_degc"]
    u, v, w = scaled(x), scaled(warmth), scaled(t)
    return y, {
        **of_drivers(y, x, warmth=warmth),
        **{name: model for name, model in usual_and_shifts(y, x, t, 3).items() if name in ("drift", "shift", "lag")},
        "slope by warmth alone": line(y, x, u * v),
        "fourth power": line(y, x, u**2, u**3, u**4),
        "cube, and drift": line(y, x, u**2, u**3, w),
        "cube, and warmth": line(y, x, u**2, u**3, v),
        "cube, and slope by warmth": line(y, x, u**2, u**3, v, u * v),
        "cube, and slope by warmth alone": line(y, x, u**2, u**3, u * v),
        "cube, and warmth, bent": line(y, x, u**2, u**3, v, v**2),
        "cube, warmth, and drift": line(y, x, u**2, u**3, v, w),
    }
