"""What the motor gives that lifts the upper arm of a robot, 56 s, every second reading. The arm weighs by the cosine of its angle; friction is against the motion."""

import numpy as np
from models.fitting import line
from readers.figaroh import joint

HAND_BUILT = "friction, speed and gravity"


def rows(position, effort):
    t, angle, motor = joint(position, effort, "arm_2", "effort")
    return {"time_s": t, "angle_rad": angle, "motor": motor}


def models(c):
    y, x, t = c["motor"], c["angle_rad"], c["time_s"]
    speed = np.gradient(x, t)
    against = np.tanh(speed / 0.01)
    return y, {
        "constant": line(y),
        "drift": line(y, t),
        "angle": line(y, x),
        "angle, bent": line(y, x, x**2),
        "speed": line(y, speed),
        "friction": line(y, against),
        "friction, and speed": line(y, against, speed),
        "friction, and angle": line(y, against, x),
        "friction, and gravity": line(y, against, np.sin(x), np.cos(x)),
        HAND_BUILT: line(y, against, speed, np.sin(x), np.cos(x)),
    }
