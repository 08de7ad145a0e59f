"""Absorbance of tablets at 1440 nm in one of two spectrometers of one kind over that in the other, 642 tablets. Next to nothing is missing."""

from meters import absorbances
from monitors import bends_with

HAND_BUILT = "line"


def rows(content):
    (first,), (second,) = (absorbances(content, instrument, 1440) for instrument in (1, 2))
    return {"first_absorbance": first, "second_absorbance": second}


def models(c):
    return c["second_absorbance"], bends_with(c["second_absorbance"], c["first_absorbance"])
