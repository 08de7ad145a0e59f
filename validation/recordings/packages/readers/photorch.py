"""Reads files of the package photorch."""

from formats.text import csv


def leaves(content):
    """Readings of leaves in a chamber that had come to rest, a run a leaf: what they take up, how open their pores are, and how dry the air is for them."""
    frame = csv(content, encoding="utf-8-sig").sort_values("CurveID", kind="stable")
    return {"run": frame.CurveID + 1, "uptake_umol": frame.A, "deficit_kpa": frame.VPDleaf, "conductance_mol": frame.gsw}
