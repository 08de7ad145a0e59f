"""Reads files of the package openap."""

from formats.text import csv


def flight(content, begin, every, scale=None, **names):
    """Columns of a flight from some second on, each so many of the rows that have numbers in all of them; seconds since the first, and columns by the names that they are to have."""
    frame = csv(content)
    frame = frame[frame.ts > begin].dropna(subset=list(names.values())).iloc[::every]
    time = frame.ts.to_numpy() - frame.ts.iloc[0]
    return {"time_s": time, **{name: frame[column].to_numpy() * (scale or {}).get(name, 1) for name, column in names.items()}}


def engines(content):
    """Jet engines with their flow of fuel when they take off, in the order of the list: bypass ratio, thrust in kN, fuel in kg/s. Those that mix their streams are left out."""
    frame = csv(content)
    frame = frame[frame.type == "TF"].dropna(subset=["bpr", "max_thrust", "ff_to"])
    return {"bypass": frame.bpr, "thrust_kn": frame.max_thrust / 1000, "fuel_kg_s": frame.ff_to}
