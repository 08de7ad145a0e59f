"""Water in meat over its fat: the parts add up, so protein takes the place of water."""

from models.fitting import line
from readers.rdatasets import frame

HAND_BUILT = "line in fat and protein"


def rows(content):
    d = frame(content)
    return {"fat": d.fat, "protein": d.protein, "water": d.water}


def models(c):
    y, fat = c["water"], c["fat"]
    return y, {"line": line(y, fat), HAND_BUILT: line(y, fat, c["protein"])}
