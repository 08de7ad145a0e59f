"""Current of transistors over voltage, ten wafers of eight sites: 80 runs. A transistor follows a square law; the wafers differ."""

from models.fitting import line
from readers.rdatasets import frame

HAND_BUILT = "square law"


def rows(content):
    d = frame(content)
    d = d.assign(run=(d.Wafer.astype(int) - 1) * 8 + d.Site.astype(int)).sort_values(["run", "voltage"])
    return {"run": d.run, "voltage_v": d.voltage, "current_ma": d.current}


def models(c):
    y, v = c["current_ma"], c["voltage_v"]
    return y, {"line": line(y, v), HAND_BUILT: line(y, v, v * v)}
