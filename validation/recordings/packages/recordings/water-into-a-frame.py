"""How much water a frame of metal and acid takes up over the pressure of the water: in, out and in again on a balance. It opens at one pressure, and is full."""

from models.bends import bends_with, levels_off
from models.fitting import line, scaled, terms
from readers.datalabicb import sorption

HAND_BUILT = "two ways of filling"
BRANCHES = (("pads1 / hPa", "maads1 / (g.g-1)"), ("pdes1 / hPa", "mades1 / (g.g-1)"), ("pads2 / hPa", "maads2 / (g.g-1)"))


def rows(content):
    return dict(zip(("pressure_hpa", "taken_up"), sorption(content, 532, *BRANCHES)))


def models(c):
    y, x = c["taken_up"], c["pressure_hpa"]
    u, filled = scaled(x), lambda at, power: 1 / (1 + (abs(at) / x) ** abs(power))
    return y, {
        **bends_with(y, x),
        "fourth power": line(y, x, u**2, u**3, u**4),
        **levels_off(y, x, 1.0),
        "hyperbola, and line": terms(y, lambda p: [x, x / (x + abs(p[0]))], [1.0]),
        "filling": terms(y, lambda p: [filled(*p)], [1.0, 1.0]),
        "filling, and line": terms(y, lambda p: [x, filled(*p)], [1.0, 2.0]),
        "two ways of filling": terms(y, lambda p: [filled(*p[:2]), filled(*p[2:])], [1.0, 4.0, 1.0, 1.0]),
        "two ways of filling, and line": terms(y, lambda p: [x, filled(*p[:2]), filled(*p[2:])], [1.0, 4.0, 1.0, 1.0]),
    }
