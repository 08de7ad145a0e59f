"""High voltage of a detector in a soot photometer on a ship in the ice, a day in means of a minute, as its chamber cools and warms by 10 K: 27 mV/K."""

from formats.soot_photometer import mean_rows, photometer
from models.fitting import line, terms
from models.lags import lag

HAND_BUILT = "temperature, and its lag"


def rows(content):
    return mean_rows(photometer(content, chamber_c="Chamber Temp (C)", chamber_hpa="Chamber Pressure (mBar)", high_voltage="Chan 3 HV (V)"), 60)


def models(c):
    y, x, t = c["high_voltage"], c["chamber_c"], c["time_s"]
    return y, {
        "constant": line(y),
        "temperature": line(y, x),
        "square of temperature": line(y, x, x**2),
        "lagged temperature": terms(y, lambda p: [lag(x, t, abs(p[0]) * 60)], [10.0]),
        HAND_BUILT: terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 60)], [30.0]),
        "temperature and drift": line(y, x, t),
        "temperature and pressure": line(y, x, c["chamber_hpa"]),
    }
