"""Reads files of the package pyZiagn."""

import numpy as np
from formats.rows import means


def pulled_specimen(content, every=4):
    """A specimen that is pulled: seconds, way of the crosshead in mm, load in kN and way of the extensometer in mm, means of some readings, until the load first falls by more than a twentieth of a kN from one to the next."""
    lines = content.decode("utf-8-sig").splitlines()[8:]
    table = np.array([[float(cell.replace(",", ".")) for cell in text.split("\t")] for text in lines if text.strip()])
    last = int(np.flatnonzero(np.diff(table[:, 1]) < -0.05)[0]) - 5
    way, load, seconds, gauge = (means(column[:last], every) for column in table.T)
    return {"time_s": seconds.round(4), "way_mm": np.abs(way), "load_kn": load, "gauge_mm": gauge}
