"""Reads files of the package cpvlib."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv


def sunny_station(content, lowest=None, **names):
    """Minutes of a station, those in which the sun is higher than so many degrees where that is told, columns by the names that they are to have; seconds since the first."""
    frame = csv(content, sep="\t", parse_dates=[0])
    frame = frame if lowest is None else frame[frame["Elev.Sol"] > lowest]
    return {"time_s": seconds(frame.iloc[:, 0]), **{name: frame[column] for name, column in names.items()}}


def solar_module(content, begin, end, least):
    """A module on a roof between two days while the sun sends it at least so much: how warm the air and its back are, and the wind; seconds since the first."""
    frame = csv(content, encoding="latin1", skipinitialspace=True)
    when, sun = pd.to_datetime(frame["Date Time"], format="%d-%b-%Y %H:%M:%S"), frame["DNI (W/m2)"]
    kept = (when >= begin) & (when < end) & (sun > least)
    air, wind, back = (frame.columns[frame.columns.str.startswith(name)][0] for name in ("T_Amb", "Wind Speed", "T_Backplane"))
    return {"time_s": seconds(when[kept]), "air_degc": frame[air][kept], "wind_m_s": frame[wind][kept], "back_degc": frame[back][kept]}
