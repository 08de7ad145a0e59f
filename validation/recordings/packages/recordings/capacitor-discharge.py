"""Voltage of a capacitor that discharges through a resistor."""

import numpy as np
from models.fitting import line, terms
from readers.rdatasets import frame

HAND_BUILT = "exponential to a level"


def rows(content):
    d = frame(content)
    return {"time_s": d.Time, "voltage_v": d.Voltage}


def models(c):
    y, t = c["voltage_v"], c["time_s"]
    return y, {"line": line(y, t), HAND_BUILT: terms(y, lambda p: [np.exp(-t / abs(p[0]))], [0.5])}
