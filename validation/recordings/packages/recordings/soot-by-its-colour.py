"""Absorption of light by the air in a town over soot, two months. Soot is counted in the infrared, absorption in the green; how much more that is depends on the colour."""

import numpy as np
from models.bends import bends_with
from models.fitting import curve, line
from readers.aeroviz import air_station

HAND_BUILT = "colour, slope by it, and square"


def rows(content):
    read = air_station(content, "BC", "Absorption", "AAE370880")
    return {"time_s": read.time_s, "soot_ug_m3": read.BC / 1000, "absorption": read.Absorption, "colour": read.AAE370880}


def models(c):
    y, x, t, colour = c["absorption"], c["soot_ug_m3"], c["time_s"], c["colour"]
    power = lambda p: p[0] + p[1] * 10 * x * np.exp(p[2] * (colour - 1.2))
    return y, {
        **bends_with(y, x, drift=t, colour=colour),
        "power of the colour": curve(y, power, [0, 1.3, 0.5]),
        "power of the colour, and square": curve(y, lambda p: power(p) + p[3] * x**2, [0, 1.3, 0.5, 0.0]),
        "colour, slope by it, and square": line(y, x, colour, x * colour, x**2),
        "colour, slope by it, and drift": line(y, x, colour, x * colour, t),
    }
