"""Reads files of the package aeroviz."""

import io

import pandas as pd


def air_station(content, *names):
    """Hours of a station for the air with a number in each of the columns; seconds since the first hour of the table."""
    frame = pd.read_csv(io.BytesIO(content), usecols=["Time", *names], parse_dates=["Time"])
    frame = frame.assign(time_s=(frame.Time - frame.Time.iloc[0]).dt.total_seconds())
    return frame.dropna()
