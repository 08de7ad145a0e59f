"""Carbon dioxide over the water vapour that one analyser reads in the same path, above a field by day, 20 readings a second, five minutes. Leaves take one and give the other."""

from models.fitting import line
from models.lags import usual
from readers.fluxpart import eddy_station

HAND_BUILT = "drift, and temperature"


def rows(content):
    frame = eddy_station(content)
    return {"time_s": frame.time_s, "vapour_g_m3": frame.h2o, "sonic_c": frame.Ts, "carbon_dioxide_mg_m3": frame.co2}


def models(c):
    y, x, t, degrees = c["carbon_dioxide_mg_m3"], c["vapour_g_m3"], c["time_s"], c["sonic_c"]
    return y, {**usual(y, x, t, 0.1), "temperature": line(y, x, degrees), HAND_BUILT: line(y, x, degrees, t)}
