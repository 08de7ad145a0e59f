"""Thermal expansion of copper over temperature; the model is the certified one of NIST."""

from formats.nist import nist
from models.fitting import curve, line

HAND_BUILT = "cubic over cubic"


def rows(content):
    return nist(content, ["expansion_coefficient", "temperature_k"])


def models(c):
    y, x = c["expansion_coefficient"], c["temperature_k"] / 100
    start = [1.08, -12.3, 40.9, -0.143, -0.576, 2.4, -0.0123]

    def ratio(p):
        return (p[0] + p[1] * x + p[2] * x**2 + p[3] * x**3) / (1 + p[4] * x + p[5] * x**2 + p[6] * x**3)

    return y, {"line": line(y, x), HAND_BUILT: curve(y, ratio, start)}
