"""Light by a recorder on the back of a seal over the depth to which it dives, two hours at dusk, a row each five seconds. It becomes night."""

from models.bends import usual_and_bends
from models.fitting import line
from readers.scikit_divemove import seal

HAND_BUILT = "slope that drifts"


def rows(content):
    frame = seal(content, 33, 35)
    return {"time_s": frame.time_s, "depth_m": frame.depth, "light_level": frame.light}


def models(c):
    y, x, t = c["light_level"], c["depth_m"], c["time_s"]
    return y, {
        **usual_and_bends(y, x, t, 30),
        "drift, and its square": line(y, x, t, t**2),
        "bend, drift, and its square": line(y, x, x**2, t, t**2),
        "slope that drifts": line(y, x, t, t**2, x * t),
    }
