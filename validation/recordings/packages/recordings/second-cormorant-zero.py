"""Depth by the logger on another cormorant while it is calm and out of the water, beside the temperature of the logger, 39 hours, about 3000 rows. The zero follows the temperature."""

from fitting import lag, line, terms
from instruments import out_of_water

HAND_BUILT = "temperature"


def rows(content):
    frame = out_of_water(content)
    return {"time_s": frame.time_s, "logger_c": frame.temperature, "depth_m": frame.pressure}


def models(c):
    y, x, t = c["depth_m"], c["logger_c"], c["time_s"]
    late = lambda p: lag(x, t, abs(p) * 600)
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        HAND_BUILT: line(y, x),
        "temperature, bent": line(y, x, x**2),
        "temperature, and drift": line(y, x, t),
        "temperature, bent, and drift": line(y, x, x**2, t),
        "temperature, and late temperature": terms(y, lambda p: [x, late(p[0])], [1.0]),
        "temperature, late temperature, and drift": terms(y, lambda p: [x, late(p[0]), t], [1.0]),
    }
