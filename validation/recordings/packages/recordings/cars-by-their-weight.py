"""How far cars of 1970 to 1982 go with a gallon, over their weight. They came to need less, and what is light goes farther than a straight line says."""

from models.drivers import of_drivers
from models.fitting import line, scaled
from readers.islp import cars

HAND_BUILT = "square, and slope by year"


def rows(content):
    return cars(content)


def models(c):
    y, x, year = c["miles_gallon"], c["weight_lb"], c["year"]
    u, v = scaled(x), scaled(year)
    return y, {
        **of_drivers(y, x, year=year),
        "slope by year alone": line(y, x, u * v),
        "one over weight": line(y, 1 / x),
        "one over weight, and year": line(y, 1 / x, v),
        "one over weight, and slope by year": line(y, 1 / x, v, v / x),
    }
