"""Strength of 1030 cylinders of concrete over their cement: it hardens with age, quickly at first, and water takes from it. Slag and ash are left out on purpose."""

import numpy as np
from models.fitting import line
from readers.rdatasets import frame

HAND_BUILT = "log of age, and water"


def rows(content):
    d = frame(content)
    return {"age_d": d.age, "cement_kg_m3": d.cement, "gravel_kg_m3": d.coarse_aggregate, "water_kg_m3": d.water, "strength": d.compressive_strength}


def models(c):
    y, cement, water, age = c["strength"], c["cement_kg_m3"], c["water_kg_m3"], c["age_d"]
    old = np.log(age)
    return y, {"line": line(y, cement), "age": line(y, cement, age), "log of age": line(y, cement, old), HAND_BUILT: line(y, cement, old, water)}
