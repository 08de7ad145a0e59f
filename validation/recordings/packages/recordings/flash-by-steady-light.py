"""Fluorescence of leaves in a flash over that in the light they stand in. In the sun a leaf turns what it cannot use into heat, and less of a flash comes back."""

import numpy as np
from models.drivers import of_drivers
from models.fitting import line, terms
from readers.phytorch_lib import porometer

HAND_BUILT = "slope by light"


def rows(content):
    read = porometer(content, "Fs", "Fm'", "Qamb")
    return {"time_s": read.time_s, "steady_fluorescence": read.Fs, "flash_fluorescence": read["Fm'"], "light_umol": read.Qamb}


def models(c):
    y, x, light, t = c["flash_fluorescence"], c["steady_fluorescence"] / 100, c["light_umol"] / 1000, c["time_s"] / 3600
    ending = lambda p: np.exp(-light / abs(p))
    return y, {
        **of_drivers(y, x, light=light),
        "drift": line(y, x, t),
        "slope by light, and drift": line(y, x, light, x * light, t),
        "light that ends": terms(y, lambda p: [x, ending(p[0])], [1.0]),
        "slope by light that ends": terms(y, lambda p: [x, ending(p[0]), x * ending(p[0])], [1.0]),
    }
