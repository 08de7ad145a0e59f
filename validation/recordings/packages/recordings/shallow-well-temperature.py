"""Temperature of the water in another well of the same field, beside that of the barometer above it, 19 months, every fourth hour. Warmth needs weeks to come down."""

from formats.clock import seconds
from models.fitting import line, terms
from models.lags import lag
from readers.gensor import wells

HAND_BUILT = "lag of a lag"


def rows(first, second, barometer):
    frame = wells(first, second, barometer).iloc[::4]
    return {"time_s": seconds(frame.when), "air_c": frame.degc, "water_c": frame.degc_1}


def models(c):
    y, x, t = c["water_c"], c["air_c"], c["time_s"]
    late = lambda p, u: lag(u, t, abs(p) * 1e6)
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "temperature": line(y, x),
        "temperature, and drift": line(y, x, t),
        "late temperature": terms(y, lambda p: [late(p[0], x)], [1.0]),
        "late temperature, and drift": terms(y, lambda p: [late(p[0], x), t], [1.0]),
        HAND_BUILT: terms(y, lambda p: [late(p[0], late(p[0], x))], [1.0]),
    }
