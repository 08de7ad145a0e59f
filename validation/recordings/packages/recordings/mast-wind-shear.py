"""Wind at 80 m against the power law from 40 m: the shear follows direction (fetch, mast), and a little the hour of the day."""

import numpy as np
import pandas as pd
from formats.clock import seconds
from formats.text import csv
from models.cycles import tone
from models.fitting import line

HAND_BUILT = "hour and direction"
DAY = 86400  # s


def rows(content):
    d = csv(content, skiprows=range(1, 30001), nrows=3000)[["Timestamp", "Spd80mS", "Spd40mS", "Dir78mS", "T2m"]].dropna()
    d = d.assign(t=pd.to_datetime(d.Timestamp)).drop_duplicates("t").sort_values("t")
    d = d[d.Spd40mS > 1]
    return {"time_s": seconds(d.t), "air_c": d.T2m, "direction_deg": d.Dir78mS, "power_law": d.Spd40mS * 2 ** (1 / 7), "speed_80m": d.Spd80mS}


def models(c):
    y, x, around = c["speed_80m"], c["power_law"], np.radians(c["direction_deg"])
    hour = [x * wave for wave in tone(c["time_s"], DAY)]
    direction = [x * wave(k * around) for k in (1, 2) for wave in (np.cos, np.sin)]
    return y, {"line": line(y, x), "hour": line(y, x, *hour), HAND_BUILT: line(y, x, *hour, *direction)}
