"""Reads files of the package pyfat."""

from formats.clock import since_first
from formats.text import csv


def pulled_specimen(content):
    """A specimen that is pulled, each 0.06 s from 6 s on until shortly before it breaks: seconds, position in mm, load in kN, strain in per cent."""
    frame = csv(content).iloc[600:12400:6, [0, 6, 7, 8]]
    frame.columns = ["time_s", "position_mm", "load_kn", "strain_pct"]
    return frame.assign(time_s=since_first(frame.time_s))


def fatigue_cycles(content, share=0.9):
    """Cycles of a fatigue test without the first three and the last tenth: seconds, the largest position in mm, load in kN and strain in per cent."""
    frame = csv(content)
    frame = frame.iloc[3 : int(len(frame) * share), [3, 5, 7, 9]]
    frame.columns = ["time_s", "position_mm", "load_kn", "strain_pct"]
    return frame.assign(time_s=since_first(frame.time_s))
