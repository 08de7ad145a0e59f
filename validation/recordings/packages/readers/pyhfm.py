"""Reads files of the package pyhfm."""

import re

import pandas as pd


def heat_flow_meter(content):
    """Blocks of a heat flow meter: temperature of the upper and the lower plate, and what their transducers read; without the first ones, which are out of range."""
    found = re.findall(r"^\s*-[a-z]+-\s+(\S+)\s+(\S+)\s+(\S+)\s+(\S+)\s+\S+\s*$", content.decode("utf-16"), re.M)
    frame = pd.DataFrame([[float(v) for v in row] for row in found], columns=["upper_c", "lower_c", "upper_uv", "lower_uv"])
    return frame[(frame.upper_uv.abs() < 19500) & (frame.lower_uv.abs() < 19500)].reset_index(drop=True)
