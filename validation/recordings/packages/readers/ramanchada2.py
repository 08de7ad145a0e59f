"""Reads files of the package ramanchada2."""

import numpy as np
import pandas as pd


def spectrum(content, column):
    """A column of numbers of a spectrometer's file by its name, over the shift of the light in 1/cm; pixels without a wavelength are left out."""
    lines = [text.split(";") for text in content.decode("latin1").splitlines()]
    first = next(k for k, cells in enumerate(lines) if cells[0] == "Pixel")
    head, table = lines[first], [[cell.strip().replace(",", ".") for cell in cells] for cells in lines[first + 1 :]]
    frame = pd.DataFrame(table).iloc[:, : len(head)].set_axis(head, axis=1)
    told = frame[["Wavelength", "Raman Shift", column]].apply(pd.to_numeric, errors="coerce").dropna()
    return told["Raman Shift"].to_numpy(), told[column].to_numpy()


def powers(contents, milliwatts, weakest, between, every):
    """Spectra of one sample under a laser of several powers, a run a spectrum, over the mean of those at the least power, which come first."""
    parts, least = [], []
    for run, (content, power) in enumerate(zip(contents, milliwatts, strict=True), 1):
        shift, counts = spectrum(content, "Dark Subtracted #1")
        counts = counts[(shift > between[0]) & (shift < between[1])][::every]
        if run <= weakest:
            least.append(counts)
        else:
            parts.append(pd.DataFrame({"run": run - weakest, "weak_counts": np.mean(least, axis=0), "strong_counts": counts, "power_mw": power}))
    return pd.concat(parts, ignore_index=True)
