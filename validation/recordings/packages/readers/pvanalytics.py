"""Reads files of the package pvanalytics."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv


def solar_array(content):
    """The columns of the solar array `NREL RSF II` that are used here: 15 min, five winter days."""
    names = {
        "ambient_temp__1053": "ambient",
        "module_temp__1056": "module",
        "poa_irradiance__1055": "poa",
        "poa_irradiance_refcell__1054": "refcell",
        "refcell_temp__1052": "refcell_temp",
        "wind_speed__1051": "wind",
        "inv2_temp__1050": "inverter_temp",
        "inv2_dc_power__1135": "dc_power",
        "inv2_ac_power_w__1047": "ac_power",
    }
    frame = csv(content)
    out = frame.rename(columns=names)[list(names.values())]
    return out.assign(time_s=seconds(pd.to_datetime(frame.iloc[:, 0])))
