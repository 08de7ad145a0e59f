"""Voltage of a thermistor on the heat sink of the crystal in a soot photometer over the temperature of its chamber, a day in means of half a minute. The chamber cools and warms by 10 K; the sink follows it a few minutes later, and a thermistor is bent."""

from formats.soot_photometer import mean_rows, photometer
from models.fitting import terms
from models.lags import lag, usual

HAND_BUILT = "bent, and a part late"


def rows(content):
    return mean_rows(photometer(content, chamber_c="Chamber Temp (C)", thermistor_v="Crystal HeatSink ThermBuf"), 30)


def models(c):
    y, x, t = c["thermistor_v"], c["chamber_c"], c["time_s"]
    late = lambda p: lag(x, t, abs(p) * 60)
    return y, {
        **usual(y, x, t),
        "bent lag": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [3.0]),
        "a part late": terms(y, lambda p: [x, late(p[0])], [3.0]),
        "two lags": terms(y, lambda p: [lag(late(p[0]), t, abs(p[1]) * 60)], [3.0, 1.0]),
        HAND_BUILT: terms(y, lambda p: [x, x**2, late(p[0])], [3.0]),
    }
