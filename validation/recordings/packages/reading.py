"""Formats that several recordings share, from bytes to columns."""

import io

import numpy as np
import pandas as pd


def nist(content, columns):
    """The data of a file of the NIST Statistical Reference Datasets."""
    lines = content.decode().splitlines()
    start = max(k for k, line in enumerate(lines) if line.startswith("Data:")) + 1
    values = np.array([[float(v) for v in line.split()] for line in lines[start:] if line.strip()])
    return dict(zip(columns, values.T))


def csv(content, **options):
    """A CSV as a data frame."""
    return pd.read_csv(io.BytesIO(content), **options)


def seconds(times):
    """Seconds since the first of a column of times."""
    return (times - times.iloc[0]).dt.total_seconds().to_numpy()


def numbers(content):
    """One number a line; lines that begin with # are comments."""
    return np.array([float(line) for line in content.decode().splitlines() if line[:1] != "#"])


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


def cast(content, rows=None):
    """The rows of a lowering of a CTD, by time: those with numbers in all of the first ten columns."""
    with np.load(io.BytesIO(content), allow_pickle=False) as file:
        frame = pd.DataFrame(file["data"].T, columns=list(file["varnames"]))
    frame = frame[(np.abs(frame.iloc[:, :10]) < 1e4).all(axis=1)]
    return frame[frame["timeS"].diff().fillna(1) > 0].iloc[:rows]


def ameriflux(content, begin, end, names):
    """Columns of a half-hourly AmeriFlux file between two days: rows with numbers in all of them, and seconds since the first day."""
    frame = csv(content, skiprows=2, na_values=[-9999], usecols=["TIMESTAMP_START", *names])
    at = pd.to_datetime(frame.TIMESTAMP_START.astype(str), format="%Y%m%d%H%M")
    kept = (at >= begin) & (at < end) & frame[names].notna().all(axis=1)
    return frame[kept].assign(time_s=(at[kept] - pd.Timestamp(begin)).dt.total_seconds())
