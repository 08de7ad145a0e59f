"""Fuel that jet engines burn on the test stand when they take off, over their thrust. The more air goes around the core, the less fuel a thrust takes."""

from models.drivers import of_drivers
from models.fitting import line, scaled, through_zero
from readers.openap import engines

HAND_BUILT = "slope by bypass"


def rows(content):
    return engines(content)


def models(c):
    y, x, bypass = c["fuel_kg_s"], c["thrust_kn"], c["bypass"]
    u, v = scaled(x), scaled(bypass)
    return y, {
        **of_drivers(y, x, bypass=bypass),
        "slope by bypass alone": line(y, x, u * v),
        "product": through_zero(y, x, x * bypass),
        "product, bent": through_zero(y, x, x * bypass, x * bypass**2),
        "slope by bypass, bent": line(y, x, v, u * v, v**2),
        "slope by bypass and its square": line(y, x, v, u * v, v**2, u * v**2),
    }
