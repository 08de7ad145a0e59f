"""Speed that a robot gives of a joint of its arm, beside that which its angle makes from row to row, 56 s, every second reading. It is filtered."""

import numpy as np
from models.fitting import terms
from models.lags import lag, usual
from readers.figaroh import joint

HAND_BUILT = "lag"


def rows(position, speed):
    t, angle, given = joint(position, speed, "arm_3", "velocity")
    return {"time_s": t, "by_angle_rad_s": np.gradient(angle, t), "speed_rad_s": given}


def models(c):
    y, x, t = c["speed_rad_s"], c["by_angle_rad_s"], c["time_s"]
    return y, {**usual(y, x, t, 0.1), "lag of a lag": terms(y, lambda p: [lag(lag(x, t, abs(p[0]) * 0.1), t, abs(p[0]) * 0.1)], [0.5])}
