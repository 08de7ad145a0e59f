"""Light of a cyan lamp over that of another of its kind, 64 settings of both. The brighter both are, the more it falls behind."""

from fitting import line, scaled
from monitors import bends_with
from tellers import one_side, two_lamps

HAND_BUILT = "power"


def rows(*contents):
    return two_lamps(*contents, number=4)


def models(c):
    y, x = c["second"], c["first"]
    u = scaled(x)
    return y, {
        "as it is": lambda seen: x,
        "zero": lambda seen: x + (y - x)[seen].mean(),
        **bends_with(y, x),
        "fourth power": line(y, x, u**2, u**3, u**4),
        **one_side(y, x, x.max() / 4),
    }
