"""Pull of the cable of a probe in a gas well over its depth, means of 20 rows, from 100 ft on. The cable weighs the same by the foot; it rubs at the casing here and there. The clock is made of depth and of the speed of the cable."""

import numpy as np
from formats.las import well_log
from formats.rows import means
from models.fitting import line
from models.lags import usual

HAND_BUILT = "square"


def rows(content):
    frame = well_log(content)
    depth, speed, pull = (means(frame[name], 20) for name in ("DEPT", "SPEED", "TEN"))
    deep = depth > 100
    lasts = np.diff(depth[deep], prepend=depth[deep][0]) / np.abs(speed[deep]) * 60
    return {"time_s": np.cumsum(lasts), "depth_ft": depth[deep], "tension_lb": pull[deep]}


def models(c):
    y, x, t = c["tension_lb"], c["depth_ft"], c["time_s"]
    return y, {**usual(y, x, t, 100), "cubic": line(y, x, x**2, x**3)}
