"""Light on a wrist by the minute over its green part, as logarithms, with how much more blue and red there is than green. All three colours count."""

import numpy as np
from formats.text import csv
from models.fitting import line

HAND_BUILT = "blue and red"


def rows(content):
    frame = csv(content, sep=";", skiprows=24)
    frame = frame.assign(time_s=60.0 * np.arange(len(frame)))
    frame = frame[(frame.LIGHT > 1) & (frame["GREEN LIGHT"] > 0.3) & (frame["RED LIGHT"] > 0.3) & (frame["BLUE LIGHT"] > 0.1)]
    light, red, green, blue = (np.log10(frame[name]) for name in ("LIGHT", "RED LIGHT", "GREEN LIGHT", "BLUE LIGHT"))
    return {"time_s": frame.time_s, "log_green": green, "log_light": light, "blue": blue - green, "red": red - green}


def models(c):
    y, x, blue, red = c["log_light"], c["log_green"], c["blue"], c["red"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, c["time_s"]),
        "red": line(y, x, red),
        "blue": line(y, x, blue),
        HAND_BUILT: line(y, x, blue, red),
        "blue and red, square": line(y, x, blue, red, x**2),
    }
