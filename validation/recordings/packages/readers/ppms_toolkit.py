"""Reads files of the package ppms-toolkit."""

from formats.multivu import multivu


def moments(content, every):
    """Rows of a magnetometer in which it has measured a moment, each so many."""
    return multivu(content).dropna(subset=["Moment (emu)"]).iloc[::every]
