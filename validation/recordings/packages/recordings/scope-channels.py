"""First channel of an oscilloscope over its second while one edge goes by, 14 us. The first is slower than the second."""

from models.lags import usual_and_lags
from readers.rigolwfm import scope

HAND_BUILT = "lag"


def rows(content):
    return scope(content)


def models(c):
    return c["first_v"], usual_and_lags(c["first_v"], c["second_v"], c["time_s"], 3e-7)
