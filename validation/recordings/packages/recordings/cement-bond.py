"""Loss of sound along a casing, by the first of six sectors, over the mean amplitude that arrives, a gas well from 200 ft on, every fifth row. The loss is a logarithm. The clock is made of depth and of the speed of the cable."""

import numpy as np
from formats.las import well_log
from models.fitting import line
from models.lags import usual

HAND_BUILT = "logarithm"


def rows(content):
    frame = well_log(content).iloc[::5].query("DEPT > 200")
    lasts = frame.DEPT.diff().fillna(0) / frame.SPEED.abs() * 60
    return {"time_s": lasts.cumsum(), "amplitude_mv": frame.AMAV, "loss_db_ft": frame.ATC1}


def models(c):
    y, x, t = c["loss_db_ft"], c["amplitude_mv"], c["time_s"]
    return y, {
        **usual(y, x, t, 10),
        "cubic": line(y, x, x**2, x**3),
        HAND_BUILT: line(y, np.log(x)),
        "logarithm, and drift": line(y, np.log(x), t),
    }
