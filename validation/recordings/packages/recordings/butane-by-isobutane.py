"""Butane in air over isobutane, hours of four months, by one chromatograph. Both leak from the same places and stay about as long."""

from models.drifts import usual_and_drifts
from readers.tucavoc import chromatograph

HAND_BUILT = "line"


def rows(content):
    read = chromatograph(content, "isobutane", "butane")
    return {"time_s": read.time_s, "isobutane_karea": read.isobutane, "butane_karea": read.butane}


def models(c):
    return c["butane_karea"], usual_and_drifts(c["butane_karea"], c["isobutane_karea"], c["time_s"])
