"""Reads files of the package d47calib."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv


def one_session(content, session, **names):
    """Columns of one session of a mass spectrometer that has dates and times, in their order; seconds since the first."""
    frame = csv(content)
    frame = frame[frame.Session == session]
    when = pd.to_datetime(frame.Date + " " + frame.Time)
    frame = frame.assign(time_s=when).sort_values("time_s", kind="stable")
    return {"time_s": seconds(frame.time_s), **{name: frame[column].to_numpy() for name, column in names.items()}}


def by_session(content, **names):
    """Columns of all sessions of a mass spectrometer, a run a session, numbered as they come; rows that miss a number are left out."""
    frame = csv(content).dropna()
    number = {session: k for k, session in enumerate(dict.fromkeys(frame.Session), 1)}
    frame = frame.assign(run=frame.Session.map(number)).sort_values("run", kind="stable")
    return {"run": frame.run.to_numpy(), **{name: frame[column].to_numpy() for name, column in names.items()}}
