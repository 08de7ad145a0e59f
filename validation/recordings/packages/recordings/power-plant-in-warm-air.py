"""What a power plant with gas and steam turbines gives over the warmth of the air, hours of six years in no order. Damp air and steam that does not condense well take some."""

from formats.text import columns
from models.drivers import of_drivers
from models.fitting import line, scaled

HAND_BUILT = "all squares"


def rows(content):
    return columns(content, 8000, humidity_percent="RH", vacuum_cmhg="V", air_degc="AT", power_mw="PE")


def models(c):
    y, x, damp, vacuum = c["power_mw"], c["air_degc"], c["humidity_percent"], c["vacuum_cmhg"]
    u, v, w = scaled(x), scaled(damp), scaled(vacuum)
    return y, {
        **of_drivers(y, x, humidity=damp, vacuum=vacuum),
        "both": line(y, x, v, w),
        "both, and square": line(y, x, u**2, v, w),
        "slope by humidity, and vacuum": line(y, x, v, w, u * v),
        "humidity, and slope by vacuum": line(y, x, v, w, u * w),
        "slopes by both": line(y, x, v, w, u * v, u * w),
        "slopes by both, and square": line(y, x, u**2, v, w, u * v, u * w),
        "both, bent": line(y, x, v, w, v**2, w**2),
        "all squares": line(y, x, u**2, v, w, v**2, w**2, u * v, u * w, v * w),
    }
