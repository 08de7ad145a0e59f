"""Reads files of the package modelskill."""

import io
import zipfile

import numpy as np

SECONDS = {"minutes": 60, "hours": 3600, "days": 86400}


def compared(content, member):
    """What was measured and what a model says at one place, by name, and seconds since the first row."""
    from netCDF4 import Dataset

    with zipfile.ZipFile(io.BytesIO(content)) as archive, Dataset("place", memory=archive.read(member)) as data:
        found = {name: np.ma.filled(one[:].astype(float), np.nan) for name, one in data.variables.items() if one.dimensions == ("time",)}
        unit = data["time"].units.split()[0]
    return {**found, "time_s": (found["time"] - found["time"][0]) * SECONDS[unit]}
