"""Mobility of electrons over the logarithm of their density; the model is the certified one of NIST."""

from formats.nist import nist
from models.fitting import curve, line

HAND_BUILT = "cubic over cubic"


def rows(content):
    return nist(content, ["mobility", "log_density"])


def models(c):
    y, x = c["mobility"], c["log_density"]
    start = [1288, 1491, 583, 75, 0.966, 0.398, 0.05]

    def ratio(p):
        return (p[0] + p[1] * x + p[2] * x**2 + p[3] * x**3) / (1 + p[4] * x + p[5] * x**2 + p[6] * x**3)

    return y, {"line": line(y, x), HAND_BUILT: curve(y, ratio, start)}
