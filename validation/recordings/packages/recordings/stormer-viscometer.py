"""Time that a Stormer viscometer takes for 100 turns, against the ideal instrument: friction takes a part of the weight (Williams 1959)."""

from models.fitting import curve, line
from readers.rdatasets import frame

HAND_BUILT = "b1 viscosity / (weight - b2)"


def rows(content):
    d = frame(content)
    return {"viscosity_cp": d.Viscosity, "weight_g": d.Wt, "newtonian_s": 30 * d.Viscosity / d.Wt, "turn_s": d.Time}


def models(c):
    y, v, weight = c["turn_s"], c["viscosity_cp"], c["weight_g"]
    return y, {"line": line(y, c["newtonian_s"]), HAND_BUILT: curve(y, lambda p: p[0] * v / (weight - p[1]), [29.0, 2.0])}
