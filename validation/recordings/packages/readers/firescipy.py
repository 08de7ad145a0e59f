"""Reads files of the package firescipy."""

import io

import pandas as pd


def thermobalance(content):
    """A thermobalance: seconds, weight in mg, temperature of the sample."""
    return pd.read_csv(io.BytesIO(content), sep="\t", skiprows=2, header=None, encoding="latin1", names=["row", "sample_c", "time_s", "weight_mg", "program_c"])
