"""Heights across the raceway of the inner ring of a roller bearing over the place on it."""

from models.bends import bends
from models.fitting import line, scaled
from readers.tribology import near_top, profile

HAND_BUILT = "square"
NEAR_TOP_UM, EVERY = 12, 4


def rows(content):
    places, heights = near_top(*profile(content), below=NEAR_TOP_UM, every=EVERY)
    return {"place_mm": places, "height_um": heights}


def models(c):
    y, x = c["height_um"], c["place_mm"]
    u = scaled(x)
    return y, {**bends(y, x), "fourth power": line(y, u, u**2, u**3, u**4), "sixth power": line(y, *(u**k for k in range(1, 7)))}
