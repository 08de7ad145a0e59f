"""What a day of the turning Earth is too long, by the clocks of the world, every third day of ten years. Winds and tides slow it by the season."""

from models.cycles import tone
from models.fitting import line
from readers.astropy_iers_data import earth_orientation

HAND_BUILT = "yearly cycle"


def rows(content):
    t, out = earth_orientation(content, 53736, 3653, "LOD")
    return {"time_s": t[::3], "excess_ms": out[::3] * 1000}


def models(c):
    y, t = c["excess_ms"], c["time_s"]
    year = 365.2425 * 86400
    cycle = [*tone(t, year), *tone(t, year / 2)]
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "one wave": line(y, *tone(t, year)),
        HAND_BUILT: line(y, *cycle),
        "yearly cycle and drift": line(y, *cycle, t),
    }
