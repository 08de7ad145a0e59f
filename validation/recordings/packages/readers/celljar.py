"""Reads files of the package celljar."""

import pandas as pd


def cycler(content):
    """Rows of a battery cycler: seconds, current, voltage and what it does."""
    lines = [line.split(",") for line in content.decode("latin1").splitlines() if line[:3] == "No,"]
    frame = pd.DataFrame([[float(line[k]) for k in (1, 8, 9)] for line in lines], columns=["time_s", "ampere", "volt"])
    return frame.assign(mode=[line[13] for line in lines])
