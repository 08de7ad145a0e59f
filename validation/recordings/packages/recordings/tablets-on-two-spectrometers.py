"""Absorbance of tablets at 1440 nm in one of two spectrometers of one kind over that in the other, 642 tablets. Next to nothing is missing."""

from fitting import line
from meters import absorbances

HAND_BUILT = "line"


def rows(content):
    (first,), (second,) = (absorbances(content, instrument, 1440) for instrument in (1, 2))
    return {"first_absorbance": first, "second_absorbance": second}


def models(c):
    y, x = c["second_absorbance"], c["first_absorbance"]
    u = x - x.mean()
    return y, {"line": line(y, x), "square": line(y, x, u**2), "cube": line(y, x, u**2, u**3)}
