"""How much water goes through gates into a marsh, a row a week, 1980 to 2006."""

from durations import YEAR
from models.cycles import tone
from models.fitting import line, scaled
from models.jumps import changed
from readers.pyedm import gates

HAND_BUILT = "three waves a year, and drift"


def rows(content):
    return gates(content)


def models(c):
    y, t = c["flow"], c["time_s"]
    w, waves = scaled(t), {n: [part for k in range(1, n + 1) for part in tone(t, YEAR / k)] for n in (1, 2, 3, 5)}
    return y, {
        "constant": line(y),
        "drift": line(y, w),
        "drift, and its square": line(y, w, w**2),
        "step": changed(y, t, [], 1.0),
        "one wave a year": line(y, *waves[1]),
        "two waves a year": line(y, *waves[2]),
        "three waves a year": line(y, *waves[3]),
        "five waves a year": line(y, *waves[5]),
        "one wave a year, and drift": line(y, w, *waves[1]),
        "three waves a year, and drift": line(y, w, *waves[3]),
        "one wave a year that grows": line(y, w, *waves[1], *(part * w for part in waves[1])),
        "one wave a year, and step": changed(y, t, waves[1], 1.0),
    }
