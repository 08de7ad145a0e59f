"""Way of an extensometer on a specimen that is pulled over that of the crosshead. Until it yields, the grips and the frame give way more than the length between the clips."""

from models.bends import corner, usual_and_bends
from models.fitting import line
from readers.pyziagn import pulled_specimen

HAND_BUILT = "fourth power"


def rows(content):
    read = pulled_specimen(content)
    return {"time_s": read["time_s"], "crosshead_mm": read["way_mm"], "gauge_mm": read["gauge_mm"]}


def models(c):
    y, x, t = c["gauge_mm"], c["crosshead_mm"], c["time_s"]
    u = x / 2 - 1
    return y, {
        **usual_and_bends(y, x, t, 5),
        "square, and drift": line(y, x, x**2, t),
        "fourth power": line(y, *(u**k for k in range(1, 5))),
        "corner": corner(y, x, 1.5),
    }
