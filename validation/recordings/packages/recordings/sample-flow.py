"""Flow of air through a soot photometer, held at 120 cm3/min by its controller, a day in means of a minute, as the chamber cools and warms by 10 K: it holds. There is more noise in the morning."""

import numpy as np
from formats.soot_photometer import mean_rows, photometer
from models.fitting import line

HAND_BUILT = "constant"


def rows(content):
    return mean_rows(photometer(content, chamber_c="Chamber Temp (C)", chamber_hpa="Chamber Pressure (mBar)", flow_cm3_min="Sample Flow LFE (vccm)"), 60)


def models(c):
    y, x, t = c["flow_cm3_min"], c["chamber_c"], c["time_s"]
    return y, {"constant": line(y), "temperature": line(y, x), "pressure": line(y, c["chamber_hpa"]), "drift": line(y, t), "rate of temperature": line(y, np.gradient(x))}
