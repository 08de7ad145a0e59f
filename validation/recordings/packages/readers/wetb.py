"""Reads files of the package wetb."""

import numpy as np
from formats.netcdf import dataset, filled
from formats.rows import means


def turbine_sensors(content):
    """Ten minutes of a wind turbine by the name of its sensor, means of 10 readings, 2.5 rows a second; seconds since the first."""
    with dataset(content) as file:
        names = [str(name).strip() for name in file["attribute_names"][:]]
        table = filled(file["block0000/data"])
    read = {name: means(values, 10) for name, values in zip(names, table.T)}
    return {"time_s": np.arange(len(read[names[0]])) * 0.4, **read}
