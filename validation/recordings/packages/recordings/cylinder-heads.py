"""Temperature of one cylinder's head over that of another's, from shortly after an aircraft's engine was started, two minutes and a quarter. One warms later."""

from models.lags import usual_and_lags
from readers.aerotrace_parsers import engine

HAND_BUILT = "lag, and square"


def rows(content):
    frame = engine(content, 90)
    return {"time_s": frame.time_s, "fourth_f": frame.CHT4, "sixth_f": frame.CHT6}


def models(c):
    return c["sixth_f"], usual_and_lags(c["sixth_f"], c["fourth_f"], c["time_s"], 5)
