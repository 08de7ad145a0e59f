"""Second pulses of a caesium clock against a hydrogen maser, 6.4 days in means of five minutes: the two run at different rates. The first hour, in which the counter was set, is left away."""

import gzip

import numpy as np
from formats.rows import means
from models.cycles import tone
from models.fitting import line
from readers.allantools import numbers

HAND_BUILT = "drift"


def rows(content):
    late = means(numbers(gzip.decompress(content))[3600:], 300) * 1e9
    return {"time_s": (np.arange(len(late)) + 0.5) * 300, "late_ns": late}


def models(c):
    y, t = c["late_ns"], c["time_s"]
    day = tone(t, 86400.0)
    return y, {"constant": line(y), HAND_BUILT: line(y, t), "drift that bends": line(y, t, t**2), "drift and hours of the day": line(y, t, *day)}
