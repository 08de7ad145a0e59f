"""Voltage of a nerve cell, from 40 ms before a current through it is stepped up by 37 pA until shortly before its first spike, 4000 rows a second. Its skin is a capacitor."""

from benches import cell_voltage
from fitting import lag, line, terms, usual

HAND_BUILT = "two lags beside each other"


def rows(current, voltage):
    return cell_voltage(current, voltage, 2650, 3100)


def models(c):
    y, x, t = c["voltage_mv"], c["current_pa"], c["time_s"]
    late = lambda p: lag(x, t, abs(p) * 0.01)
    return y, {
        **usual(y, x, t, 0.01),
        "line and lag": terms(y, lambda p: [x, late(p[0])], [2.0]),
        HAND_BUILT: terms(y, lambda p: [late(p[0]), late(p[1])], [2.0, 20.0]),
        "lag, and drift": terms(y, lambda p: [late(p[0]), t], [2.0]),
        "lag, and square": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [2.0]),
        "lag, drift, and its square": terms(y, lambda p: [late(p[0]), t, t**2], [2.0]),
    }
