"""Speed of sound that a current meter tells over the temperature of the water, two weeks on a mooring, each 8 min. It is bent."""

from models.fitting import line
from readers.oceanarray import aquadopp

HAND_BUILT = "square"


def rows(content):
    frame = aquadopp(content)
    return {"time_s": frame.time_s, "water_c": frame[23], "sound_m_s": frame[16]}


def models(c):
    y, x, t = c["sound_m_s"], c["water_c"], c["time_s"]
    return y, {"line": line(y, x), HAND_BUILT: line(y, x, x**2), "cubic": line(y, x, x**2, x**3), "drift": line(y, x, t)}
