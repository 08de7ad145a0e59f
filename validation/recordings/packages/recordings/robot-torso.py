"""What the motor gives that lifts the torso of a robot, 56 s, every second reading. The weight is the same at any height; friction is against the motion."""

import numpy as np
from models.fitting import line
from readers.figaroh import joint

HAND_BUILT = "friction, and speed"


def rows(position, effort):
    t, height, motor = joint(position, effort, "torso_lift", "effort")
    return {"time_s": t, "height_m": height, "motor": motor}


def models(c):
    y, x, t = c["motor"], c["height_m"], c["time_s"]
    speed = np.gradient(x, t)
    against = np.tanh(speed / 0.003)
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "height": line(y, x),
        "speed": line(y, speed),
        "friction": line(y, against),
        HAND_BUILT: line(y, against, speed),
        "friction, and height": line(y, against, x),
    }
