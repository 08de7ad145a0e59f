"""Reads files of the package figaroh."""

from formats.text import csv


def joint(position, other, name, what):
    """One joint of a robot from 10 to 66 s, every second of its readings: seconds, position, and another column. Before and after its file is filled in by curves."""
    where, beside = csv(position).iloc[::2], csv(other).iloc[::2]
    kept = (where.t >= 10) & (where.t < 66)
    return where.t[kept] - 10, where[f"- {name}_joint_position"][kept], beside[f"- {name}_joint_{what}"][kept]
