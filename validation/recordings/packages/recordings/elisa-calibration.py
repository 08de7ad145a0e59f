"""Optical density of an ELISA over known concentrations, 11 runs: the logistic curve of the field."""

from models.fitting import line, terms
from readers.rdatasets import frame

HAND_BUILT = "logistic in log concentration"


def rows(content):
    d = frame(content)
    return {"run": d.Run.astype(int), "conc": d.conc, "density": d.density}


def models(c):
    y, x = c["density"], c["conc"]
    return y, {"line": line(y, x), HAND_BUILT: terms(y, lambda p: [1 / (1 + (p[0] / x) ** p[1])], [4.0, 1.0])}
