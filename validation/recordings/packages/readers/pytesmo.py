"""Reads files of the package pytesmo."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv


def wet_soil(probe, satellite, minutes):
    """How wet soil is by a satellite and by a good reading of a probe so near to it in time; seconds since the first."""
    told = csv(probe, parse_dates=["date_time"]).rename(columns={"date_time": "when"})
    seen = csv(satellite, parse_dates=[0])
    seen = seen.rename(columns={seen.columns[0]: "when"}).dropna(subset=["sm"])
    both = pd.merge_asof(seen, told[told.soil_moisture_flag == "G"], on="when", direction="nearest", tolerance=pd.Timedelta(minutes=minutes))
    both = both.dropna(subset=["soil_moisture"])
    return {"time_s": seconds(both.when), "satellite_percent": both.sm, "probe_m3_m3": both.soil_moisture}
