"""Reads files of the package mirror-soiling-data."""

import io

import pandas as pd
from formats.clock import seconds


def weather(content):
    """Rows of a station beside mirrors with a number in every column, and seconds since the first."""
    return sheet(content, "Weather").dropna()


def sheet(content, name):
    """A sheet of a workbook whose first column is the time, in rows that have one, and seconds since the first."""
    frame = pd.read_excel(io.BytesIO(content), sheet_name=name)
    frame = frame.loc[:, ~frame.columns.str.startswith("Unnamed")].dropna(subset=["Time"])
    return frame.assign(time_s=seconds(frame.Time))


def mirrors(contents):
    """Reflectance of mirrors beside that of the first, which lies flat, campaign by campaign: a run a mirror, with the seconds of its campaign and its tilt in degrees, which its name tells."""
    runs = []
    for content in contents:
        told = sheet(content, "Reflectance_Average")
        flat, *others = [name for name in told.columns if "_T" in name]
        for name in others:
            tilt = float(name.rpartition("_T")[2])
            runs.append(pd.DataFrame({"run": len(runs) + 1, "time_s": told.time_s, "flat_pct": told[flat], "mirror_pct": told[name], "tilt_deg": tilt}).dropna())
    return pd.concat(runs, ignore_index=True)
