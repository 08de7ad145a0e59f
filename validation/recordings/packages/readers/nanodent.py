"""Reads files of the package nanodent."""

import pandas as pd


def indenter(content):
    """The table of an indentation file, under its header of settings; what follows the table is left away."""
    text = content.decode("latin1")
    lines = text[text.index("Time_s\t") :].splitlines()
    cells = [line.split("\t") for line in lines]
    kept = [row for row in cells[1:] if len(row) == len(cells[0]) and row[0][:1].isdigit()]
    return pd.DataFrame([[float(v) for v in row] for row in kept], columns=cells[0])
