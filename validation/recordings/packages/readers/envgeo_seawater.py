"""Reads files of the package envgeo-seawater."""

import io

import pandas as pd
from formats.clock import TIME_OF_DAY, seconds


def casts(content, laboratory, *names):
    """Water from the sea as one laboratory told it, means of what was taken at one time; seconds since the first."""
    frame = pd.read_excel(io.BytesIO(content))
    frame = frame[frame.PI == laboratory].dropna(subset=list(names))
    of_day = frame.Time.astype(str).str[-8:]
    when = pd.to_datetime(frame.Date) + pd.to_timedelta(of_day.where(of_day.str.fullmatch(TIME_OF_DAY), "00:00:00"))
    told = frame[list(names)].apply(pd.to_numeric).groupby(when).mean().sort_index()
    return told.assign(time_s=seconds(told.index)).reset_index(drop=True)
