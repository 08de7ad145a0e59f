"""Temperature of leaves as a thermometer for infrared told it over that of a porometer, two hours. The sun warms a leaf."""

from models.drivers import of_drivers
from models.fitting import line, terms
from models.lags import lag
from readers.phytorch_lib import porometer

HAND_BUILT = "light"


def rows(content):
    read = porometer(content, "Tref", "Tleaf", "Qamb")
    return {"time_s": read.time_s, "chamber_degc": read.Tref, "leaf_degc": read.Tleaf, "light_umol": read.Qamb}


def models(c):
    y, x, light, t = c["leaf_degc"], c["chamber_degc"], c["light_umol"] / 1000, c["time_s"] / 3600
    return y, {
        **of_drivers(y, x, light=light),
        "drift": line(y, x, t),
        "drift, and its square": line(y, x, t, t**2),
        "light, and drift": line(y, x, light, t),
        "light, and lag": terms(y, lambda p: [lag(x, t, abs(p[0])), light], [0.2]),
        "light, late": terms(y, lambda p: [x, lag(light, t, abs(p[0]) / 60)], [0.5]),
    }
