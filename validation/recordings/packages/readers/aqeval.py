"""Reads files of the package aqeval."""

import gzip

from formats.clock import seconds
from formats.text import csv


def road(content):
    """Nitrogen dioxide at a road and away from it, and the wind: means of the days that have all three; seconds since the first."""
    frame = csv(gzip.decompress(content), parse_dates=["date"]).set_index("date")[["no2", "bg.no2", "ws"]].resample("D").mean().dropna()
    return {"time_s": seconds(frame.index.to_series()), "background": frame["bg.no2"], "wind_m_s": frame.ws, "road": frame.no2}
