"""Pressure inside of the hull of a glider over the oil that its pump has moved out of the hull, beside the temperature of its board, 19 hours of dives, a row each 20 s. Oil that comes in presses the gas; gas that cools shrinks, before the board does."""

from models.fitting import line, terms
from models.lags import lag
from readers.pyglider import glider

HAND_BUILT = "temperature, and late temperature"


def rows(*contents):
    frame = glider(*contents)
    return {"time_s": frame.time_s, "ballast_cm3": frame.BallastPos, "board_c": frame.Temperature, "inside_hpa": frame.Pa / 100}


def models(c):
    y, x, t, warm = c["inside_hpa"], c["ballast_cm3"], c["time_s"], c["board_c"]
    late = lambda p: lag(warm, t, abs(p) * 60)
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "temperature": line(y, x, warm),
        "late temperature": terms(y, lambda p: [x, late(p[0])], [10.0]),
        "temperature, and square": line(y, x, x**2, warm),
        HAND_BUILT: terms(y, lambda p: [x, warm, late(p[0])], [10.0]),
        "temperature, and late temperature, and square": terms(y, lambda p: [x, x**2, warm, late(p[0])], [10.0]),
    }
