"""Two thermometers of one CTD, the whole lowering: 33 wild rows at its end. The model is that they are equal but for a constant, the median."""

import numpy as np
from models.fitting import line
from readers.cotede import ctd_cast

HAND_BUILT = "equal but for a constant"


def rows(content):
    d = ctd_cast(content)
    return {"time_s": d.timeS.round(3), "second_thermometer": d.TEMP2, "depth": d.PRES, "first_thermometer": d.TEMP}


def models(c):
    y, x = c["first_thermometer"], c["second_thermometer"]
    return y, {"line": line(y, x), HAND_BUILT: lambda seen: x + np.median((y - x)[seen])}
