"""Reads files of the package modelskill."""

from formats.netcdf import dataset, filled
from formats.packed import in_zip

SECONDS = {"minutes": 60, "hours": 3600, "days": 86400}


def model_beside_measured(content, member):
    """What was measured and what a model says at one place, by name, and seconds since the first row."""
    with dataset(in_zip(content, member)) as data:
        found = {name: filled(one) for name, one in data.variables.items() if one.dimensions == ("time",)}
        unit = data["time"].units.split()[0]
    return {**found, "time_s": (found["time"] - found["time"][0]) * SECONDS[unit]}
