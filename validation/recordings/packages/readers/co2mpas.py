"""Reads files of the package co2mpas."""

import io
import warnings

import pandas as pd


def car_on_rollers(content):
    """Seconds of a car on rollers, from the first of its tests in a workbook, by the names of the second row."""
    import openpyxl  # the other readers do without it

    with warnings.catch_warnings(action="ignore"):  # of colours of cells
        book = openpyxl.load_workbook(io.BytesIO(content), read_only=True, data_only=True)
        told = list(book["WLTP-H"].iter_rows(values_only=True))
    frame = pd.DataFrame(told[2:], columns=told[1])
    return frame.loc[:, [name is not None for name in frame.columns]].dropna(axis=1, how="all").dropna(how="all").astype(float)
