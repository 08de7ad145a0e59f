"""Drive of a thermostat that holds a radio receiver at 25 degC, over the temperature of the air, a row each ten minutes, three and a half days. Its box follows the air late."""

import pandas as pd
from formats.clock import seconds
from models.lags import late_models
from readers.edges_io import hut, thermostat

HAND_BUILT = "lag, and drift"


def rows(weather, drive):
    frame = pd.merge_asof(thermostat(drive), hut(weather), on="when", direction="nearest", tolerance=pd.Timedelta("200s")).dropna()
    return {"time_s": seconds(frame.when), "air_c": frame.air_c, "drive_pct": frame.drive_pct}


def models(c):
    return c["drive_pct"], late_models(c["drive_pct"], c["air_c"], c["time_s"], 3600)
