"""Peak acceleration at 182 accelerographs, as log10 of g, against the formula of Joyner and Boore (1981): earthquakes differ, soil does not matter.

Source of the formula: Bull. Seismol. Soc. Am. 71 (1981) 2011, equation 2, from records that are in part these. No row of an earthquake that is left out tells its difference, so the line is the model.
"""

import numpy as np
from models.fitting import line
from readers.rdatasets import frame

HAND_BUILT = "line"


def rows(content):
    d = frame(content).astype(float).sort_values(["Quake", "distance"])
    r = np.hypot(d.distance, 7.3)
    formula = -1.02 + 0.249 * d.Richter - np.log10(r) - 0.00255 * r
    columns = {"quake": d.Quake.astype(int), "distance_km": d.distance, "soil": d.soil.astype(int)}
    return {**columns, "joyner_boore": formula, "log_acceleration": np.log10(d.accel)}


def models(c):
    y, x = c["log_acceleration"], c["joyner_boore"]
    quakes = [(c["quake"] == k) * 1.0 for k in np.unique(c["quake"])[1:]]
    return y, {HAND_BUILT: line(y, x), "soil": line(y, x, c["soil"]), "distance": line(y, x, c["distance_km"]), "quakes": line(y, x, *quakes)}
