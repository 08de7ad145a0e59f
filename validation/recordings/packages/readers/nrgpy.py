"""Reads files of the package nrgpy."""

import io

import pandas as pd
from formats.clock import seconds, since_first
from formats.packed import unpacked


def mast_logger(*contents):
    """Rows of a logger for masts, one file after another, below the header of each, and seconds since the first; packed files are unpacked."""
    frames = []
    for content in contents:
        plain = unpacked(content)
        table = plain[plain.index(b"\n", plain.index(b"\nData") + 1) + 1 :]
        frames.append(pd.read_csv(io.StringIO(table.decode("latin1")), sep="\t"))
    frame = pd.concat(frames, ignore_index=True)
    when = pd.to_datetime(frame.iloc[:, 0])
    return pd.concat([frame, pd.DataFrame({"when": when, "time_s": seconds(when)})], axis=1)


def own_supplies(diagnosis, *names):
    """Supplies of a logger by their names, in mV, each the middle between the smallest and the largest of a minute, while its battery tells a number."""
    frame = mast_logger(diagnosis)
    frame = frame[frame.BATTERY_V_Min > 1]
    middles = {name: ((frame[f"{name}_Min"] + frame[f"{name}_Max"]) * 500).round(3) for name in names}
    return pd.DataFrame({"when": frame.when, "time_s": since_first(frame.time_s), **middles})
