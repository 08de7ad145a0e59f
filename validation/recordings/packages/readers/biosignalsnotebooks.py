"""Reads files of the package biosignalsnotebooks."""

import numpy as np
from formats.netcdf import dataset


def hubs(content):
    """Counts of the channels of one or more hubs for sensors on a body, by the address of the hub and the number of its channel."""
    with dataset(content) as file:
        raw = {address: hub["raw"] for address, hub in file.groups.items()}
        return {f"{address}/{name}": one[:][:, 0].astype(float) for address, hub in raw.items() for name, one in hub.variables.items() if name != "nSeq"}


def seconds_at(values, hertz):
    """Seconds of readings that come so many times a second."""
    return np.arange(len(values)) / hertz
