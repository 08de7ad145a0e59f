"""Reads files of the package rowingdata."""

import io

import pandas as pd


def speed_coach(content):
    """Strokes of a rowing computer: numbers by the names of its columns, and seconds since the start."""
    lines = content.decode("utf-8-sig").splitlines()
    start = next(k for k, text in enumerate(lines) if text.startswith("Per-Stroke Data"))
    header = next(k for k in range(start + 1, len(lines)) if lines[k].startswith("Interval,"))
    frame = pd.read_csv(io.StringIO("\n".join([lines[header], *lines[header + 2 :]])))
    clock = pd.to_timedelta(frame.pop("Elapsed Time"), errors="coerce").dt.total_seconds()
    return frame.apply(pd.to_numeric, errors="coerce").assign(time_s=clock)
