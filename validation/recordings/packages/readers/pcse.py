"""Reads files of the package pcse."""

import numpy as np
import pandas as pd
from formats.clock import seconds


def farm_days(*contents):
    """Days of a station on a farm: the coldest and the warmest in degC, the sun in MJ/m2, and the pressure of vapour; seconds since the first."""
    cells = [line.split() for content in contents for line in content.decode("latin1").splitlines() if line[:1] != "*"]
    rows = np.array([line for line in cells if len(line) == 9], float)
    when = pd.to_datetime(pd.Series(rows[:, 1].astype(int) * 1000 + rows[:, 2].astype(int)).astype(str), format="%Y%j")
    return {"time_s": seconds(when), "coldest_degc": rows[:, 4], "sun_mj_m2": rows[:, 3] / 1000, "vapour_kpa": rows[:, 6], "warmest_degc": rows[:, 5]}
