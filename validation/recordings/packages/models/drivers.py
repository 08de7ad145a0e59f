"""Something else that moves the zero or the slope."""

from models.bends import bends_with
from models.fitting import line, scaled


def of_drivers(y, x, **drivers):
    """A square and a cube, and each driver alone, bent, as a slope, and with a square."""
    u, models = scaled(x), bends_with(y, x)
    for name, z in drivers.items():
        v = scaled(z)
        models |= {name: line(y, x, v), f"{name}, bent": line(y, x, v, v**2), f"slope by {name}": line(y, x, v, u * v), f"square, and {name}": line(y, x, u**2, v)}
        models |= {f"square, and slope by {name}": line(y, x, u**2, v, u * v), f"all squares of {name}": line(y, x, u**2, v, u * v, v**2)}
    return models


def drivers_and_drift(y, x, t, **drivers):
    """Each driver beside a drift, and with all squares beside it."""
    u, w, models = scaled(x), scaled(t), {}
    for name, z in drivers.items():
        v = scaled(z)
        models |= {f"{name}, and drift": line(y, x, v, w), f"all squares of {name}, and drift": line(y, x, u**2, v, u * v, v**2, w)}
    return models


def two_drivers(y, x, **drivers):
    """Models with two drivers, by their names, beside one another."""
    u, (one, other) = scaled(x), (scaled(values) for values in drivers.values())
    both = " and ".join(drivers)
    return {
        both: line(y, x, one, other),
        f"{both}, and square": line(y, x, u**2, one, other),
        f"{both}, slope by the first": line(y, x, one, other, u * one),
        f"{both}, slope by the second": line(y, x, one, other, u * other),
        f"{both}, all slopes": line(y, x, one, other, u * one, u * other),
        f"{both}, bent": line(y, x, one, other, one**2, other**2),
    }


def gains(y, x, **drivers):
    """Models in which drivers change the slope and not the zero, each alone and all together."""
    u, parts = scaled(x), {name: scaled(z) for name, z in drivers.items()}
    models = {f"gain by {name}": line(y, x, x * v) for name, v in parts.items()}
    both = "gains by " + " and ".join(parts)
    return models | {both: line(y, x, *(x * v for v in parts.values())), f"{both}, and square": line(y, x, u**2, *(x * v for v in parts.values()))}
