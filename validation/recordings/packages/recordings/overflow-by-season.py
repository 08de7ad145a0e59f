"""Cold water that flows over a sill between islands, by current meters on the ground, 29 years, a run from one gap to the next. More flows in summer."""

from durations import GREGORIAN_YEAR
from models.cycles import tone
from models.fitting import line
from readers.amocatlas import overflow as rows

HAND_BUILT = "year, and half a year"


def models(c):
    y, t = c["flow_sv"], c["time_s"]
    year, half = tone(t, GREGORIAN_YEAR), tone(t, GREGORIAN_YEAR / 2)
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "drift, and its square": line(y, t, t**2),
        "year": line(y, *year),
        "year, and drift": line(y, *year, t),
        "year, and half a year": line(y, *year, *half),
        "year, half a year, and drift": line(y, *year, *half, t),
        "year that grows": line(y, *year, *(part * t for part in year)),
    }
