"""Petrol from ten crude oils over the end point of the distillation: a crude that boils later gives less. Its gravity counts for little."""

from models.fitting import line
from readers.rdatasets import frame

HAND_BUILT = "10 percent point"


def rows(content):
    d = frame(content)
    return {"crude_10_f": d.V10, "crude_api": d.SG, "end_point_f": d.EP, "yield_pct": d.Y}


def models(c):
    y, end, ten = c["yield_pct"], c["end_point_f"], c["crude_10_f"]
    return y, {"line": line(y, end), HAND_BUILT: line(y, end, ten), "and gravity": line(y, end, ten, c["crude_api"]), "product": line(y, end, ten, end * ten)}
