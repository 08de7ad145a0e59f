"""Infrared light that collagen in tissue takes away at one band of its protein over that at another, 195 spectra. A third band is of the hydrogen on its chains."""

from models.drivers import of_drivers
from models.fitting import line, scaled
from readers.orange_spectroscopy import tissue

HAND_BUILT = "slope by hydrogen"


def rows(content):
    return tissue(content, "collagen", hydrogen=1455, amide_one=1655, amide_two=1547)


def models(c):
    y, x, z = c["amide_two"], c["amide_one"], c["hydrogen"]
    u, v = scaled(x), scaled(z)
    return y, {**of_drivers(y, x, hydrogen=z), "hydrogen alone": line(y, v), "slope by hydrogen, and its square": line(y, u, v, u * v, v**2), "slope alone": line(y, u, u * v)}
