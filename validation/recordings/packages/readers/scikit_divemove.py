"""Reads files of the package scikit-divemove."""

from formats.clock import since_first
from formats.netcdf import netcdf

SEAL = {name: name for name in ("depth", "light", "temperature")}


def seal(content, begin, end):
    """Rows of a recorder on a seal between two hours of its clock, with a number in every column, a row each five seconds."""
    frame = netcdf(content, {**SEAL, "date_time": "date_time"})
    frame = frame[(frame.date_time >= begin * 3600) & (frame.date_time < end * 3600)].dropna()
    return frame.assign(time_s=since_first(frame.date_time))
