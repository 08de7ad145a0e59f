"""Heating of a thermobalance over the temperature of its furnace, 10 K/min from 100 to 800 degC, every eighth reading. Heat goes by radiation."""

from models.fitting import line, terms
from models.lags import lag
from readers.pyngb import thermal_analysis

HAND_BUILT = "cubic"


def rows(content):
    frame = thermal_analysis(content).iloc[::8]
    frame = frame[frame.furnace_c.between(100, 800) & (frame.minutes < 97)]
    return {"time_s": frame.minutes * 60, "furnace_c": frame.furnace_c, "power": frame.power}


def models(c):
    y, x, t = c["power"], c["furnace_c"], c["time_s"]
    kelvin = (x + 273) / 1000
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        HAND_BUILT: line(y, x, x**2, x**3),
        "radiation": line(y, x, kelvin**4),
        "drift": line(y, x, t),
        "lag": terms(y, lambda p: [lag(x, t, abs(p[0]) * 60)], [1.0]),
    }
