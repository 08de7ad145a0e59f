"""Power that an inverter gives over the power that it takes: losses grow with the square, and with the voltage. What it takes is output over efficiency."""

from formats.text import csv
from models.fitting import line

HAND_BUILT = "by voltage"


def rows(content):
    d = csv(content)
    return {"dc_kw": d.ac_power / d.efficiency / 1e3, "dc_v": d.dc_voltage, "ac_kw": d.ac_power / 1e3}


def models(c):
    y, x, volts = c["ac_kw"], c["dc_kw"], c["dc_v"]
    return y, {"line": line(y, x), "square": line(y, x, x**2), "square and voltage": line(y, x, x**2, volts), HAND_BUILT: line(y, x, x**2, volts, volts * x, volts * x**2)}
