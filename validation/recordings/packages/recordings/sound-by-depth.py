"""Speed of sound that a current meter uses over the speed that it tells, beside the pressure, two weeks on a mooring, each 8 min. Sound is faster where it is deep."""

from models.fitting import line
from readers.oceanarray import aquadopp

HAND_BUILT = "pressure"


def rows(content):
    frame = aquadopp(content)
    return {"time_s": frame.time_s, "told_m_s": frame[16], "pressure_dbar": frame[21], "used_m_s": frame[17]}


def models(c):
    y, x, p, t = c["used_m_s"], c["told_m_s"], c["pressure_dbar"], c["time_s"]
    return y, {"line": line(y, x), "square": line(y, x, x**2), "drift": line(y, x, t), HAND_BUILT: line(y, x, p), "pressure, bent": line(y, x, p, p**2)}
