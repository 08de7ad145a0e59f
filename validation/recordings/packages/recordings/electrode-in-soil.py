"""pH by an electrode that a tractor presses into a field over pH by the laboratory, 250 places. The electrode sees the soil as it lies, with its water and what holds it."""

import numpy as np
from models.bends import bends_with
from models.fitting import line
from readers.limesoda import soil_samples

HAND_BUILT = "carbon, and slope by the logarithm of the resistance"
PH, CARBON, RESISTANCE, ELECTRODE = 1, 0, 5, 7


def rows(content):
    laboratory, carbon, resistance, electrode = soil_samples(content, PH, CARBON, RESISTANCE, ELECTRODE)
    return {"laboratory_ph": laboratory, "carbon_pct": carbon, "resistance_ohm_m": resistance, "electrode_ph": electrode}


def models(c):
    y, x, carbon, resistance = c["electrode_ph"], c["laboratory_ph"], c["carbon_pct"], c["resistance_ohm_m"]
    dry = np.log(resistance)
    return y, {
        **bends_with(y, x, carbon=carbon, resistance=resistance),
        "carbon, bent": line(y, x, carbon, carbon**2),
        "carbon, and resistance": line(y, x, carbon, resistance),
        "slope by the logarithm of the resistance": line(y, x, dry, x * dry),
        "carbon, and slope by resistance": line(y, x, carbon, resistance, x * resistance),
        "carbon, and slope by the logarithm of the resistance": line(y, x, carbon, dry, x * dry),
    }
