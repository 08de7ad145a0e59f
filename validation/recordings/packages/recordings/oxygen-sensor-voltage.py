"""Oxygen over the voltage of a sensor on a CTD, by the formula of its maker: a gain by solubility, which falls with temperature, and depth.

The salinity that the maker used is no column of the recording; the model takes 35 g/kg throughout.
"""

import numpy as np
from models.fitting import line

HAND_BUILT = "volts times solubility, temperature and depth"
SALINITY = 35.0


def rows(content):
    lines = content.decode("latin1").split("*END*")[1].split("\n")[1:]
    a = np.array([[float(v) for v in line.split()] for line in lines if len(line.split()) == 12])
    return {"water_c": a[:, 2], "depth_db": a[:, 1], "volts": a[:, 4], "oxygen": a[:, 6]}


def solubility(warm, salinity):
    """Oxygen in saturated sea water, mL/L. Source: Garcia and Gordon 1992, equation 8, constants of Benson and Krause."""
    x = np.log((298.15 - warm) / (273.15 + warm))
    fresh = np.polyval([3.88767, -0.256847, 4.94457, 4.0501, 3.22014, 2.00907], x)
    salt = np.polyval([-0.00817083, -0.010341, -0.00737614, -0.00624523], x)
    return np.exp(fresh + salinity * salt - 4.88682e-7 * salinity**2)


def models(c):
    y, volts, warm, depth = c["oxygen"], c["volts"], c["water_c"], c["depth_db"]
    soluble = solubility(warm, SALINITY)
    gain = line(y, volts * soluble, soluble)
    return y, {"line": line(y, volts), "volts times solubility": gain, HAND_BUILT: line(y, volts * soluble, soluble, volts * soluble * warm, volts * soluble * depth)}
