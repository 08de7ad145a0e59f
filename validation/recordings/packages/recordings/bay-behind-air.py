"""Temperature of the water at a beach over that of the air, half hours of six times in two summers. Water warms late, and in the second summer it was colder for its air."""

from durations import DAY
from models.fitting import line, terms
from models.lags import lag, late_models, moved
from readers.ai4water import beach

HAND_BUILT = "lag, and step"


def rows(content):
    read = beach(content, "air_temp_c", "wat_temp_c")
    return {"time_s": read.time_s, "air_degc": read.air_temp_c, "water_degc": read.wat_temp_c}


def models(c):
    y, x, t = c["water_degc"], c["air_degc"], c["time_s"]
    second = (t > 200 * DAY) * 1.0
    late = lambda p: lag(x, t, abs(p) * DAY)
    return y, {
        **late_models(y, x, t, 2 * DAY),
        "step": line(y, x, second),
        "lag, and step": terms(y, lambda p: [late(p[0]), second], [1.0]),
        "line and lag, and step": terms(y, lambda p: [x, late(p[0]), second], [1.0]),
        "shift, and step": terms(y, lambda p: [moved(x, t, p[0] * DAY), second], [0.1]),
        "lag, step, and drift": terms(y, lambda p: [late(p[0]), second, t], [1.0]),
    }
