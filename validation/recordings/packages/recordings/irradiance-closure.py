"""Global irradiance against its sum of direct and diffuse light: the sum is too high in the mornings, in proportion to the direct light."""

import numpy as np
import pandas as pd
from formats.clock import seconds
from formats.text import csv
from models.cycles import tone
from models.fitting import line

HAND_BUILT = "direct light times the hour of the day"
DAY = 86400  # s


def rows(content):
    d = csv(content).dropna()
    d = d.assign(t=pd.to_datetime(d.measured_on))
    d = d[d.pvlib_zenith < 85].drop_duplicates("t").sort_values("t")
    direct = d.irradiance_dni__7982
    closure = direct * np.cos(np.radians(d.pvlib_zenith)) + d.irradiance_dhi__7983
    return {"time_s": seconds(d.t), "zenith_deg": d.pvlib_zenith, "dni": direct, "closure": closure, "ghi": d.irradiance_ghi__7981}


def models(c):
    y, x, direct = c["ghi"], c["closure"], c["dni"]
    hours = [direct * wave for share in (1, 2, 3) for wave in tone(c["time_s"], DAY / share)]
    return y, {"line": line(y, x), "direct light and zenith": line(y, x, direct, c["zenith_deg"]), HAND_BUILT: line(y, x, direct, *hours)}
