"""Temperature inside of a glider's cell for conductivity over that of the water, one dive in polar water, a row a second. The cell is behind the water."""

from models.lags import usual_and_lags
from readers.seagliderog1 import polar_glider

HAND_BUILT = "lag, and drift"


def rows(content):
    frame = polar_glider(content)
    return {"time_s": frame.time_s, "water_c": frame.water, "cell_c": frame.cell}


def models(c):
    return c["cell_c"], usual_and_lags(c["cell_c"], c["water_c"], c["time_s"], 20)
