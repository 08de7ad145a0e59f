"""netCDF files; what is masked or not there is nan."""

import numpy as np
import pandas as pd


def dataset(content):
    """A netCDF file, open to be read."""
    import netCDF4  # the other formats do without it

    return netCDF4.Dataset("memory", memory=content)


def filled(variable):
    """Numbers of a variable."""
    return np.ma.filled(variable[:].astype(float), np.nan)


def netcdf(content, names):
    """Columns of a netCDF file by the names that they are to have."""
    with dataset(content) as file:
        return pd.DataFrame({name: filled(file[column]) for name, column in names.items()})
