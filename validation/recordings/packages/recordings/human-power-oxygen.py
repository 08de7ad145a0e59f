"""Oxygen uptake over power on a cycle, one athlete a run: a straight line below the threshold of lactate."""

from models.fitting import line
from readers.rdatasets import frame

HAND_BUILT = "line"


def rows(content):
    d = frame(content).sort_values("id", kind="stable")
    return {"run": d.id.astype(int), "watts_per_kg": d.wattsPerKg, "oxygen_uptake": d.o2}


def models(c):
    y, power = c["oxygen_uptake"], c["watts_per_kg"]
    return y, {HAND_BUILT: line(y, power), "square": line(y, power, power * power)}
