"""What the motor gives that turns the arm of a robot about a vertical axis, 56 s, every second reading. Nothing is lifted; friction is against the motion, more where it is quick, and the arm has inertia."""

import numpy as np
from models.fitting import line
from readers.figaroh import joint

HAND_BUILT = "friction, speed and inertia"


def rows(position, effort):
    t, angle, motor = joint(position, effort, "arm_1", "effort")
    return {"time_s": t, "angle_rad": angle, "motor": motor}


def models(c):
    y, x, t = c["motor"], c["angle_rad"], c["time_s"]
    speed = np.gradient(x, t)
    against, rate = np.tanh(speed / 0.01), np.gradient(speed, t)
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "angle": line(y, x),
        "speed": line(y, speed),
        "friction": line(y, against),
        "friction, and speed": line(y, against, speed),
        "friction, speed, and angle": line(y, against, speed, x),
        HAND_BUILT: line(y, against, speed, rate),
    }
