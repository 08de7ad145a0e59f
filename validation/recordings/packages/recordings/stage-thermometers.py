"""Two thermometers of a stage that is warmed, a day of scans, every second point. The second also follows the hut around it, for which a thermometer of the optics stands."""

from models.fitting import line, terms
from models.lags import lag
from readers.spec2nexus import every_second_point

HAND_BUILT = "optics"


def rows(content):
    frame = every_second_point(content)
    return {"time_s": frame.time_s, "control_k": frame.T_control_LS340, "sample_k": frame.T_sample_LS340, "optics_k": frame.HRMTemp1}


def models(c):
    y, x, optics, t = c["sample_k"], c["control_k"], c["optics_k"], c["time_s"]
    return y, {
        "line": line(y, x),
        "square": line(y, x - 298, (x - 298) ** 2),
        "drift": line(y, x, t),
        "line and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 2000)], [1.0]),
        HAND_BUILT: line(y, x, optics),
        "optics, bent": line(y, x, optics - 297, (optics - 297) ** 2),
        "late optics": terms(y, lambda p: [x, lag(optics, t, abs(p[0]) * 2000)], [0.5]),
        "optics and drift": line(y, x, optics, t),
        "gain by optics": line(y, x, (optics - 297) * (x - 298)),
    }
