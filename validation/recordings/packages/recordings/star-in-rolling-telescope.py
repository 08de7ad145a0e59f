"""Light of a star that a telescope in space tells each half hour for six days, while it rolls and is pushed back. Pixels do not see alike, and the telescope settles."""

from durations import DAY
from models.fitting import line, scaled, terms
from numpy import exp
from readers.lightkurve import shaken_star

HAND_BUILT = "drift, its square, and way, cube"


def rows(content):
    return shaken_star(content)


def models(c):
    y, way, t = c["light"], c["way_px"], c["time_s"]
    s, w = scaled(t), scaled(way)
    early, rolled = [s, s**2, s**3], [w, w**2, w**3]
    return y, {
        "constant": line(y),
        "way": line(y, w),
        "way, cube": line(y, *rolled),
        "drift": line(y, s),
        "drift, and its square": line(y, *early[:2]),
        "drift that ends": terms(y, lambda p: [exp(-t / abs(p[0] * DAY))], [3.0]),
        "drift, and way": line(y, s, w),
        "drift, and way, square": line(y, s, *rolled[:2]),
        "drift, and way, cube": line(y, s, *rolled),
        "squares of both": line(y, *early[:2], *rolled[:2]),
        "drift, its square, and way, cube": line(y, *early[:2], *rolled),
        "cubes of both": line(y, *early, *rolled),
        "cubes of both, and products": line(y, *early, *rolled, s * w, s * w**2, s**2 * w),
    }
