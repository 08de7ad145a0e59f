"""Yearly flow of the Nile at Aswan, 1871 to 1970: it falls at once after 1898."""

from models.fitting import line
from readers.rdatasets import frame

HAND_BUILT = "step after 1898"
YEAR = 365.25  # d


def rows(content):
    d = frame(content)
    return {"time_d": (d.time.astype(float) - 1871) * YEAR, "flow": d.value.astype(float)}


def models(c):
    y, year = c["flow"], 1871 + c["time_d"] / YEAR
    return y, {"constant": line(y), "line": line(y, year - 1871), HAND_BUILT: line(y, (year > 1898.5) * 1.0)}
