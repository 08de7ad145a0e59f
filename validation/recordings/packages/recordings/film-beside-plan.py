"""Dose that a film tells over that of its plan, each second millimetre of a field of 145 by 105 mm. A scanner may not see alike at all places of its lamp."""

from models.drivers import of_drivers
from models.fitting import line, scaled
from readers.dosepy import film

HAND_BUILT = "all squares of place"


def rows(measured, planned):
    return film(measured, planned, millimetres=1, every=2)


def models(c):
    y, x, place = c["film_gy"], c["planned_gy"], c["place_mm"]
    u, v = scaled(x), scaled(place)
    return y, {
        "as it is": lambda seen: x,
        **of_drivers(y, x, place=place),
        "slope by place alone": line(y, x, u * v),
        "slope by place, and its square": line(y, x, v, u * v, v**2, u * v**2),
        "all squares of place, and slope by its square": line(y, x, u**2, v, u * v, v**2, u * v**2),
    }
