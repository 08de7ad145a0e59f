"""Power of a solar array over irradiance: from about 42 h on another share of it works, as where snow slides off."""

from models.fitting import line
from readers.pvanalytics import solar_array

HAND_BUILT = "another gain from 42 h on"


def rows(content):
    d = solar_array(content)
    d = d[d.poa > 5]
    return {"time_s": d.time_s, "module": d.module, "poa": d.poa, "dc_power_kw": d.dc_power / 1e3}


def models(c):
    y, light, warm = c["dc_power_kw"], c["poa"], c["module"]
    late = (c["time_s"] > 42 * 3600) * 1.0
    return y, {
        "line": line(y, light),
        "temperature coefficient of the gain": line(y, light, light * warm),
        HAND_BUILT: line(y, light, light * late),
        "another gain and offset from 42 h on": line(y, light, light * late, late),
    }
