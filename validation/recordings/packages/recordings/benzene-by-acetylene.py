"""Benzene in air over acetylene, hours of four months, by one chromatograph. Both come from what burns; towards summer one of them goes sooner than the other."""

from models.drifts import usual_and_drifts
from readers.tucavoc import chromatograph

HAND_BUILT = "slope that drifts, square of the time"


def rows(content):
    read = chromatograph(content, "ethyne", "benzene")
    return {"time_s": read.time_s, "acetylene_karea": read.ethyne, "benzene_karea": read.benzene}


def models(c):
    return c["benzene_karea"], usual_and_drifts(c["benzene_karea"], c["acetylene_karea"], c["time_s"])
