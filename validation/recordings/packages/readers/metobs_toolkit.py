"""Reads files of the package metobs-toolkit."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv


def weather_station(content, name):
    """Rows of one of the weather stations of a table, by their time."""
    frame = csv(content, sep=";")
    frame = frame[frame.Vlinder == name]
    return frame.assign(when=pd.to_datetime(frame.Datum + " " + frame["Tijd (UTC)"])).set_index("when")


def station_pair(content, first, second, column, every=3):
    """One column of two weather stations, `_1` and `_2`, each so many rows, with seconds since the first."""
    both = weather_station(content, first)[[column]].join(weather_station(content, second)[[column]], lsuffix="_1", rsuffix="_2")
    both = both.iloc[::every].dropna()
    return seconds(both.index), both.iloc[:, 0].to_numpy(), both.iloc[:, 1].to_numpy()
