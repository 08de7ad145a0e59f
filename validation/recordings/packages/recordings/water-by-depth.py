"""Density of the water of a shallow sea over pressure, by a glider that sinks and rises, 67 minutes. Layers are not alike."""

from models.bends import usual_and_bends
from readers.gliderflight import sinking_glider

HAND_BUILT = "ninth power"


def rows(content):
    frame = sinking_glider(content).iloc[:4000]
    return {"time_s": frame.time_s, "pressure_bar": frame.pressure_bar, "density": frame.density}


def models(c):
    return c["density"], usual_and_bends(c["density"], c["pressure_bar"], c["time_s"], 10)
