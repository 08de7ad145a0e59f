"""Text files of numbers: CSV, and rows and columns without a head."""

import io

import numpy as np
import pandas as pd
from formats.clock import seconds


def matrix(content, **options):
    """Numbers in rows and columns."""
    return np.loadtxt(io.BytesIO(content), **options)


def csv(content, **options):
    """A CSV as a data frame."""
    return pd.read_csv(io.BytesIO(content), **options)


def dated(content, *names):
    """Days of a table by their date; seconds since the first."""
    frame = csv(content, parse_dates=["date"])
    return frame[list(names)].assign(time_s=seconds(frame.date))


def columns(content, rows=None, **names):
    """Columns of a CSV by the names that they are to have, its first rows where their number is told."""
    frame = csv(content).iloc[:rows]
    return {name: frame[column] for name, column in names.items()}
