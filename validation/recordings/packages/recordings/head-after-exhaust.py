"""Temperature of a cylinder's head over that of its exhaust, from shortly after an aircraft's engine was started, two minutes and a quarter. Metal warms late."""

from models.lags import usual_and_lags
from readers.aerotrace_parsers import engine

HAND_BUILT = "two lags"


def rows(content):
    frame = engine(content, 90)
    return {"time_s": frame.time_s, "exhaust_f": frame.EGT6, "head_f": frame.CHT6}


def models(c):
    return c["head_f"], usual_and_lags(c["head_f"], c["exhaust_f"], c["time_s"], 20)
