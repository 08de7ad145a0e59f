"""One coordinate of the pole about which the Earth turns, every third day of ten years: it goes round in a year and, by itself, in some 433 days."""

from models.cycles import tone
from models.fitting import line
from readers.astropy_iers_data import earth_orientation

HAND_BUILT = "year and 433 days"


def rows(content):
    t, out = earth_orientation(content, 53736, 3653, "X")
    return {"time_s": t[::3], "pole_mas": out[::3] * 1000}


def models(c):
    y, t = c["pole_mas"], c["time_s"]
    year = 365.2425 * 86400
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "yearly cycle": line(y, *tone(t, year), *tone(t, year / 2)),
        HAND_BUILT: line(y, *tone(t, year), *tone(t, 433 * 86400)),
        "year, 433 days and drift": line(y, *tone(t, year), *tone(t, 433 * 86400), t),
    }
