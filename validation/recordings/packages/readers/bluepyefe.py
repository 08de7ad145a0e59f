"""Reads files of the package bluepyefe, and holds models that its recordings share."""

import numpy as np
from models.fitting import terms
from models.lags import lag, usual

IBW_DATA = {2: 126, 5: 384}


def ibw(content):
    """Numbers of a wave of an amplifier for cells (4 bytes each, largest byte first)."""
    start = IBW_DATA[int.from_bytes(content[:2], "big")]
    return np.frombuffer(content, ">f4", 12000, start).astype(float)


def cell_voltage(current, voltage, first, last):
    """A cell between two rows, 4000 a second: seconds, current in pA, voltage in mV."""
    part = slice(first, last)
    return {"time_s": np.arange(last - first) * 0.00025, "current_pa": ibw(current)[part], "voltage_mv": ibw(voltage)[part]}


def cell_models(c, hand_built):
    """Models of a cell whose skin is a capacitor, that which is told under its name `hand_built`."""
    y, x, t = c["voltage_mv"], c["current_pa"], c["time_s"]
    late = lambda p: lag(x, t, abs(p) * 0.01)
    return y, {
        **usual(y, x, t, 0.01),
        "line and lag": terms(y, lambda p: [x, late(p[0])], [2.0]),
        hand_built: terms(y, lambda p: [late(p[0]), late(p[1])], [2.0, 20.0]),
        "lag, and drift": terms(y, lambda p: [late(p[0]), t], [2.0]),
        "lag, and square": terms(y, lambda p: [late(p[0]), late(p[0]) ** 2], [2.0]),
        "lag, drift, and its square": terms(y, lambda p: [late(p[0]), t, t**2], [2.0]),
    }
