"""Flow through dialysers over pressure, one device a run: it levels off, by height and speed that differ with the flow of blood."""

import numpy as np
from models.fitting import curve, line
from readers.rdatasets import frame

HAND_BUILT = "levels off, height and speed by blood flow"


def rows(content):
    d = frame(content)
    d = d.assign(Subject=d.Subject.astype(int)).sort_values(["Subject", "index"])
    return {"run": d.Subject, "transmembrane_dmhg": d.pressure, "blood_flow": d.QB.astype(float), "ultrafiltration": d.rate}


def models(c):
    y, x, fast = c["ultrafiltration"], c["transmembrane_dmhg"], (c["blood_flow"] > 250) * 1.0

    def levels(p):
        return (p[0] + p[3] * fast) * (1 - np.exp(-(p[1] + p[4] * fast) * (x - p[2])))

    one = curve(y, lambda p: p[0] * (1 - np.exp(-p[1] * (x - p[2]))), [55, 1, 0.2])
    return y, {"line": line(y, x), "levels off": one, HAND_BUILT: curve(y, levels, [45, 0.8, 0.2, 15, -0.2])}
