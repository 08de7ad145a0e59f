"""Position of the crosshead of a testing machine over the strain of its specimen, beside the load, each 0.06 s. What is between them is stretched by the load."""

from models.fitting import line
from readers.pyfat import pulled_specimen

HAND_BUILT = "cubic"


def rows(content):
    frame = pulled_specimen(content)
    return {"time_s": frame.time_s, "strain_pct": frame.strain_pct, "load_kn": frame.load_kn, "position_mm": frame.position_mm}


def models(c):
    y, x, load = c["position_mm"], c["strain_pct"], c["load_kn"]
    return y, {"line": line(y, x), "load": line(y, x, load), "square": line(y, x, x**2), HAND_BUILT: line(y, x, x**2, x**3), "load, and square": line(y, x, x**2, load)}
