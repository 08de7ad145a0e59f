"""Temperature by a recorder on the back of a seal over the depth to which it dives, two hours at dawn, a row each five seconds. The recorder is behind the water."""

from models.lags import usual_and_lags
from readers.scikit_divemove import seal

HAND_BUILT = "lag, and drift"


def rows(content):
    frame = seal(content, 39, 41)
    return {"time_s": frame.time_s, "depth_m": frame.depth, "recorder_c": frame.temperature}


def models(c):
    return c["recorder_c"], usual_and_lags(c["recorder_c"], c["depth_m"], c["time_s"], 60)
