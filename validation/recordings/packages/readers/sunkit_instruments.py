"""Reads files of the package sunkit-instruments."""

import numpy as np
from formats.clock import since_first
from formats.rows import means

MICRO = 1e6


def x_rays(content, *names):
    """Readings of a monitor of the sun's X-rays by the name of the detector, and seconds since the year 2000; readings are in millionths of a W/m2."""
    import netCDF4  # the other readers do without it

    with netCDF4.Dataset("memory", memory=content) as file:
        read = {name: np.ma.filled(file[name][:].astype(float), np.nan) for name in ("time", *names)}
    return {name: values if name == "time" else values * MICRO for name, values in read.items()}


def two_detectors(content, first, second, labels):
    """Two detectors of one monitor, means of two readings, a row each two seconds."""
    read = x_rays(content, first, second)
    first, second = (means(read[name], 2) for name in (first, second))
    return {"time_s": means(since_first(read["time"]), 2).round(3), **dict(zip(labels, (first, second)))}
