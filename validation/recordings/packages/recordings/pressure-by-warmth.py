"""Pressure of the air over its temperature, four years of a city by the day. Warm air is light, and the monsoon keeps the pressure low when the heat is over."""

from durations import DAY, YEAR
from formats.text import dated
from models.cycles import tone
from models.fitting import line, terms
from models.lags import lag

HAND_BUILT = "year, half of it, and drift"


def rows(content):
    read = dated(content, "meantemp", "humidity", "meanpressure")
    read = read[(read.meanpressure > 980) & (read.meanpressure < 1030)]
    return {"time_s": read.time_s, "warmth_degc": read.meantemp, "humidity_pct": read.humidity, "pressure_hpa": read.meanpressure}


def models(c):
    y, x, damp, t = c["pressure_hpa"], c["warmth_degc"], c["humidity_pct"], c["time_s"]
    year = [*tone(t, YEAR), *tone(t, YEAR / 2)]
    late = lambda p: lag(x, t, abs(p) * 10 * DAY)
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "cube": line(y, x, x**2, x**3),
        "drift": line(y, x, t),
        "damp": line(y, x, damp),
        "lag": terms(y, lambda p: [late(p[0])], [1.0]),
        "line and lag": terms(y, lambda p: [x, late(p[0])], [3.0]),
        "year": line(y, x, *year[:2]),
        "year, and half of it": line(y, x, *year),
        "year, half of it, and square": line(y, x, *year, x**2),
        "year, half of it, and drift": line(y, x, *year, t),
        "year, half of it, and lag": terms(y, lambda p: [x, late(p[0]), *year], [0.3]),
        "year, half of it, and damp": line(y, x, *year, damp),
        "year, half of it, and slope by damp": line(y, x, *year, damp, x * damp),
    }
