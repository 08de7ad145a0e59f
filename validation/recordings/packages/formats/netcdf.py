"""netCDF files; what is masked or not there is nan."""

import numpy as np
import pandas as pd


def netcdf(content, names):
    """Columns of a netCDF file by the names that they are to have; what is masked or not there is nan."""
    import netCDF4  # the other readers do without it

    with netCDF4.Dataset("memory", memory=content) as file:
        return pd.DataFrame({name: np.ma.filled(file[column][:].astype(float), np.nan) for name, column in names.items()})
