"""One probe of a logger, in the ground, over the other, in air, two and a half years, every sixth hour. Snow keeps the ground warm in winter."""

from models.cycles import tone
from models.fitting import line, terms
from models.lags import lag, usual
from readers.tsp import two_probes

HAND_BUILT = "square, and lag"
DAY = 86400.0


def rows(content):
    frame = two_probes(content)
    return {"time_s": frame.time_s, "air_c": frame["first"], "ground_c": frame.second}


def models(c):
    y, x, t = c["ground_c"], c["air_c"], c["time_s"]
    late = lambda p: lag(x, t, abs(p) * DAY)
    return y, {
        **usual(y, x, t, DAY),
        "line and lag": terms(y, lambda p: [x, late(p[0])], [3.0]),
        "bent lag": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [1.0]),
        HAND_BUILT: terms(y, lambda p: [x, x**2, late(p[0])], [3.0]),
        "cubic": line(y, x, x**2, x**3),
        "square, and year": line(y, x, x**2, *tone(t, 365.25 * DAY)),
    }
