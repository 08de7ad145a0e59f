"""Weight that an empty thermobalance shows while it is heated, two weeks after the same programme, every sixth reading; the simulation is the run before. Next to nothing is missing: a slow zero of some micrograms."""

from models.fitting import line
from readers.pyngb import programme_twice

HAND_BUILT = "drift"


def rows(first, second):
    one, two = programme_twice(first, second, 6)
    return {"time_s": two.minutes * 60, "first_mg": one.mass_mg.to_numpy(), "second_mg": two.mass_mg, "sample_c": two.sample_c}


def models(c):
    y, x, t, degrees = c["second_mg"], c["first_mg"], c["time_s"], c["sample_c"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        HAND_BUILT: line(y, x, t),
        "temperature": line(y, x, degrees),
    }
