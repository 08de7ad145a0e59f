"""Reads files of the package process-improve."""

from formats.text import csv


def dryer_batches(content, first, last):
    """Batches of a dryer from one to another."""
    frame = csv(content)
    return frame[frame.batch_id.between(first, last)]


def cooled_batches(content, first, last, before):
    """Batches of a dryer from some rows before its jacket is cooled, as if a row were a minute: the batch, its clock, and how warm jacket and product are."""
    frame = dryer_batches(content, first, last)
    starts = frame[frame.JacketTemperatureSP <= 0].groupby("batch_id").ClockTime.min()
    kept = frame[frame.ClockTime >= frame.batch_id.map(starts) - before]
    return {"run": kept.batch_id, "time_s": kept.ClockTime * 60, "jacket_degc": kept.JacketTemperature, "product_degc": kept.DryerTemp}
