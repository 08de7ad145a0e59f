"""Reads files of the package cbsyst."""

from formats.text import csv


def sea_waters(content):
    """Sea waters of a laboratory: temperature, pressure of carbon dioxide that was computed from the other two, and that which was measured."""
    frame = csv(content, comment="#")
    return {"water_degc": frame.Temp, "computed_uatm": frame.CO2SYS_fCO2, "measured_uatm": frame.fCO2}
