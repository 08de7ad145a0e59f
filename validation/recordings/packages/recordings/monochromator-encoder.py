"""Encoder of a crystal of a monochromator over what its motor was told, a day of scans, every second point. The crystal wanders from its motor."""

from models.fitting import line, terms
from models.lags import lag
from readers.spec2nexus import every_second_point

HAND_BUILT = "drift"


def rows(content):
    frame = every_second_point(content)
    return {"time_s": frame.time_s, "motor": frame.HRMth2, "encoder": frame.HRMTh2_enc}


def models(c):
    y, x, t = c["encoder"], c["motor"] + 31650, c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "cubic": line(y, x, x**2, x**3),
        HAND_BUILT: line(y, x, t),
        "drift, bent": line(y, x, t, (t / t.max()) ** 2),
        "drift of the gain": line(y, x, t, t * x / t.max()),
        "line and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 1000)], [1.0]),
    }
