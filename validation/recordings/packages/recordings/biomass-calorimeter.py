"""Heating value of 536 samples of biomass in a calorimeter against Dulong's formula of 1819: too low where there is much oxygen."""

from models.fitting import line
from readers.rdatasets import frame

HAND_BUILT = "product"


def rows(content):
    d = frame(content)
    dulong = 0.3383 * d.carbon + 1.443 * (d.hydrogen - d.oxygen / 8) + 0.0942 * d.sulfur
    return {"dulong": dulong, "nitrogen_pct": d.nitrogen, "oxygen_pct": d.oxygen, "heating_value": d.HHV}


def models(c):
    y, x, oxygen = c["heating_value"], c["dulong"], c["oxygen_pct"]
    return y, {"line": line(y, x), "oxygen": line(y, x, oxygen), "and nitrogen": line(y, x, oxygen, c["nitrogen_pct"]), HAND_BUILT: line(y, x, oxygen, x * oxygen)}
