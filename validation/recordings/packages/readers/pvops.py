"""Reads files of the package pvops."""

import io

import pandas as pd


def solar_plant(content, plant, every):
    """Hours of day at one plant, each so many: seconds since the first, and the columns by their name."""
    frame = pd.read_csv(io.BytesIO(content), parse_dates=["date"])
    frame = frame[frame.randid == plant].dropna().iloc[::every]
    return frame.assign(time_s=(frame.date - frame.date.iloc[0]).dt.total_seconds())
