"""A reference cell over a pyranometer: next to nothing is missing but snow on one of them, which no column tells. No model beat the line."""

from models.fitting import line
from readers.pvanalytics import solar_array

HAND_BUILT = "line"


def rows(content):
    d = solar_array(content)
    return d[d.poa > 5][["time_s", "refcell_temp", "poa", "refcell"]]


def models(c):
    y, light, warm = c["refcell"], c["poa"], c["refcell_temp"]
    return y, {HAND_BUILT: line(y, light), "temperature": line(y, light, light * warm, warm)}
