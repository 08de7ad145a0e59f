"""Reads files of the package clophfit."""

import io

import pandas as pd
from formats.text import csv


def plate_scans(content, notes, measurement, temperature):
    """Scans of all wells of a plate by one measurement, a column a well, and what the notes tell of the wells at a temperature, by the well."""
    told = csv(notes)
    told = told[told.Temp == temperature].set_index("Well")
    lines = content.decode("latin1").splitlines()
    first = next(k for k, text in enumerate(lines) if text.startswith("Well\t"))
    last = next(k for k, text in enumerate(lines) if k > first and not text.strip())
    frame = pd.read_csv(io.StringIO("\n".join(lines[first:last])), sep="\t")
    frame = frame[["Well", f"Meas{measurement}:WavelengthExc", f"Meas{measurement}:Result"]].set_axis(["well", "nm", "counts"], axis=1).dropna()
    return frame.pivot(index="nm", columns="well", values="counts"), told
