"""Reads files of the package qats."""

import pandas as pd
from formats.clock import elapsed
from formats.matlab import variables


def wave_basin(content, **names):
    """Channels of a wave basin by the names that they are to have; seconds since the first row."""
    file = variables(content, squeeze_me=True)
    frame = pd.DataFrame(file["data"], columns=file["chan_names"])
    return {"time_s": elapsed(frame.Time), **{name: frame[channel] for name, channel in names.items()}}


def towing_tank(content, **names):
    """Channels of a towing tank, which are variables of their own, by the names that they are to have; seconds since the first row."""
    file = variables(content, squeeze_me=True)
    return {"time_s": elapsed(file["Time"]), **{name: file[channel] for name, channel in names.items()}}
