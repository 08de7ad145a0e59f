"""Iron in slag by chemistry over a magnetic test: two methods for one quantity."""

from models.fitting import line
from readers.rdatasets import frame

HAND_BUILT = "line"


def rows(content):
    d = frame(content)
    return {"magnetic": d.magnetic * 1.0, "chemical": d.chemical * 1.0}


def models(c):
    y, x = c["chemical"], c["magnetic"]
    return y, {HAND_BUILT: line(y, x), "square": line(y, x, x * x)}
