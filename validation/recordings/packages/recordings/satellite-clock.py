"""Second pulses of a satellite receiver against a hydrogen maser, 2.8 days in means of five minutes.

They come and go with the day, as antenna and cable warm and the air above is charged by the sun.
"""

import gzip

import numpy as np
from formats.rows import means
from models.cycles import tone
from models.fitting import line
from readers.allantools import numbers

HAND_BUILT = "two waves"
DAY = 86400.0  # s


def rows(content):
    late = means(numbers(gzip.decompress(content)), 300) * 1e9
    return {"time_s": (np.arange(len(late)) + 0.5) * 300, "late_ns": late}


def models(c):
    y, t = c["late_ns"], c["time_s"]
    one, two = tone(t, DAY), [*tone(t, DAY), *tone(t, DAY / 2)]
    return y, {"constant": line(y), "drift": line(y, t), "one wave": line(y, *one), HAND_BUILT: line(y, *two), "two waves and drift": line(y, *two, t), "one wave and drift": line(y, *one, t)}
