"""Photons that plants can use over the power of sunshine, two sensors on one mast, July, each half hour. Next to nothing is missing."""

from models.lags import usual
from readers.diive import tower

HAND_BUILT = "square"


def rows(content):
    frame = tower(content, "SW_IN_1_1_1", "PPFD_IN_1_1_1")
    return {"time_s": frame.time_s, "sunshine_w_m2": frame.SW_IN_1_1_1, "photons_umol_m2_s": frame.PPFD_IN_1_1_1}


def models(c):
    return c["photons_umol_m2_s"], usual(c["photons_umol_m2_s"], c["sunshine_w_m2"], c["time_s"], 1800)
