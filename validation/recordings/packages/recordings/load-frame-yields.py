"""Largest position of each cycle of a fatigue test whose strain is held, beside the load. The specimen and the frame beyond the gauge are stretched by the load."""

from models.fitting import line
from readers.pyfat import fatigue_cycles

HAND_BUILT = "load"


def rows(content):
    frame = fatigue_cycles(content)
    return {"time_s": frame.time_s, "load_kn": frame.load_kn, "position_mm": frame.position_mm}


def models(c):
    y, load, t = c["position_mm"], c["load_kn"], c["time_s"]
    return y, {"constant": line(y), "drift": line(y, t), HAND_BUILT: line(y, load), "load, and drift": line(y, load, t), "load, bent": line(y, load, load**2)}
