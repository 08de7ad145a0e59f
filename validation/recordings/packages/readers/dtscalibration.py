"""Reads files of the package dtscalibration."""

import re

import pandas as pd


def fibre(content):
    """The cable of a fibre that measures temperature, 1 to 99 m: length, light of the two lines scattered from either end, temperature by the instrument."""
    rows = [[float(v) for v in line.split(",")] for line in re.findall(r"<data>([^<]*)</data>", content.decode())]
    frame = pd.DataFrame(rows, columns=["along", "stokes", "anti", "back_stokes", "back_anti", "degc"])
    return frame[frame.along.between(1, 99)]
