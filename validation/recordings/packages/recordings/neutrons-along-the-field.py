"""Neutrons with their spin along a field that a magnet scatters, over those against it, by where they go to: across the field what is magnetic adds to what atoms do, or takes from it."""

from models.drivers import of_drivers
from models.fitting import line, scaled
from readers.sasdata import polarised_neutrons

HAND_BUILT = "slope by across, and by way, its square"


def rows(plus, minus):
    return polarised_neutrons(plus, minus, widest=0.05, every=2)


def models(c):
    y, x, across, way = c["along"], c["against"], c["across"], c["way_1_nm"]
    u, v, w = (scaled(z) for z in (x, across, way))
    return y, {
        **of_drivers(y, x, across=across, way=way),
        "slope by across alone": line(y, x, u * v),
        "slope by across, and way": line(y, x, v, u * v, w),
        "slope by across, and by way": line(y, x, v, u * v, w, u * w),
        "slope by across, and by way, its square": line(y, x, v, u * v, w, u * w, w**2, u * w**2),
        "all products": line(y, x, v, u * v, w, u * w, v * w, u * v * w),
    }
