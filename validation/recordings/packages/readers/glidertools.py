"""Reads files of the package glidertools."""

import pandas as pd
from formats.netcdf import netcdf


def dives(contents, names):
    """Columns of one group of a glider's dives, one under the other, with the number of the dive from 1 on."""
    return pd.concat([netcdf(content, names).assign(dive=number) for number, content in enumerate(contents, 1)], ignore_index=True)
