"""Temperature of a solar module that is left to become dirty over that of a clean one beside it, 40 minutes of a winter morning, each second. Nothing is missing."""

from models.fitting import line
from models.lags import usual
from readers.nrgpy import mast_logger

HAND_BUILT = "line"


def rows(content):
    frame = mast_logger(content)
    return {"time_s": frame.time_s, "sun_w_m2": frame["Ch1_Samples_W/m^2"], "clean_c": frame.Ch3_Samples_deg_C, "dirty_c": frame.Ch5_Samples_deg_C}


def models(c):
    y, x, t, sun = c["dirty_c"], c["clean_c"], c["time_s"], c["sun_w_m2"]
    return y, {**usual(y, x, t), "sun": line(y, x, sun), "gain by sun": line(y, x, x * sun), "sun, and drift": line(y, x, sun, t)}
