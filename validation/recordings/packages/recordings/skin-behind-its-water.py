"""Light of 2.2 um that comes back from skin over light of 1.65 um that does, three places of 100 people. Water takes both away, and tells itself at 1.45 um."""

from fitting import line, scaled, terms
from levels import skins
from meters import of_drivers

HAND_BUILT = "water"


def rows(content):
    return skins(content, far=2200, near=1651, water=1450)


def models(c):
    y, x, water = c["far"], c["near"], c["water"]
    u, v = scaled(x), scaled(water)
    return y, {
        **of_drivers(y, x, water=water),
        "water alone": line(y, v),
        "slope by water alone": line(y, x, u * v),
        "product of powers": terms(y, lambda p: [x ** p[0] * water ** p[1]], [1.0, 0.5]),
        "number": line(y, x, c["run"]),
        "water, and number": line(y, x, v, c["run"]),
    }
