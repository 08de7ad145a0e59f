"""Reads files of the package sunkit-instruments."""

from formats.clock import since_first
from formats.netcdf import netcdf
from formats.rows import means

MICRO = 1e6


def x_rays(content, *names):
    """Readings of a monitor of the sun's X-rays by the name of the detector, and seconds since the year 2000; readings are in millionths of a W/m2."""
    read = netcdf(content, {name: name for name in ("time", *names)})
    return {name: read[name].to_numpy() * (1 if name == "time" else MICRO) for name in read}


def two_detectors(content, first, second, labels):
    """Two detectors of one monitor, means of two readings, a row each two seconds."""
    read = x_rays(content, first, second)
    first, second = (means(read[name], 2) for name in (first, second))
    return {"time_s": means(since_first(read["time"]), 2).round(3), **dict(zip(labels, (first, second)))}
