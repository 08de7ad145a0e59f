"""Gas that a house burns over the temperature outside, before and after its walls were filled: level and slope both fall."""

from models.fitting import line
from readers.rdatasets import frame

HAND_BUILT = "two lines"


def rows(content):
    d = frame(content)
    return {"outside_c": d.Temp, "wall_filled": (d.Insul == "After") * 1.0, "gas": d.Gas}


def models(c):
    y, outside, filled = c["gas"], c["outside_c"], c["wall_filled"]
    return y, {"line": line(y, outside), "offset": line(y, outside, filled), HAND_BUILT: line(y, outside, filled, outside * filled)}
