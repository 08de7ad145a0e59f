"""Reads files of the package lasertram."""

import io

import numpy as np
import pandas as pd
from formats.clock import since_first


def craters(content, glass, first, second):
    """Counts of two isotopes while a laser drills into a glass, in thousands a second: a run a crater, with the clock of the day and the seconds that it has been drilled."""
    frame = pd.read_excel(io.BytesIO(content), sheet_name="Buffer")
    frame = frame[frame.SampleLabel.str.startswith(f"{glass}_-_")]
    start, parts = pd.Timestamp(frame.timestamp.min()), []
    for when, shot in frame.groupby("timestamp"):
        drilled = shot.iloc[slice(*drilling(shot["29Si"].to_numpy()))]
        seconds = drilled.Time.to_numpy() / 1000
        told = {"run": len(parts) + 1, "time_s": (pd.Timestamp(when) - start).total_seconds() + seconds, "drilled_s": since_first(seconds)}
        parts.append(pd.DataFrame({**told, "first_kcps": drilled[first].to_numpy() / 1000, "second_kcps": drilled[second].to_numpy() / 1000}))
    frame = pd.concat(parts, ignore_index=True)
    return frame.assign(time_s=since_first(frame.time_s).round(3), drilled_s=frame.drilled_s.round(3))


def drilling(silicon, least=8e5):
    """First and last row in which a laser drills, less two rows at either end in which it only begins or ends."""
    rows = np.flatnonzero(silicon > least)
    return rows[0] + 2, rows[-1] - 1
