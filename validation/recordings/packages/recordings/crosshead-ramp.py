"""Position of the crosshead of a testing machine over time while it pulls a specimen, each 0.06 s. It goes as it is told."""

from models.fitting import line
from readers.pyfat import pulled_specimen

HAND_BUILT = "line"


def rows(content):
    frame = pulled_specimen(content)
    return {"time_s": frame.time_s, "load_kn": frame.load_kn, "position_mm": frame.position_mm}


def models(c):
    y, t, load = c["position_mm"], c["time_s"], c["load_kn"]
    return y, {HAND_BUILT: line(y, t), "square": line(y, t, t**2), "load": line(y, t, load)}
