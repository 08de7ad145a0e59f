"""Reads files of the package process-nitta."""

import numpy as np


def pulled_strip(content, every):
    """A strip that is pulled until it breaks, each so many rows up to the greatest force: seconds, stroke in mm, force in N. Rows are those that begin with a number, in quotes."""
    lines = [text.replace('"', "").split(",") for text in content.decode("cp932", "replace").splitlines()]
    rows = np.array([[float(cell) for cell in cells[:3]] for cells in lines if len(cells) == 4 and cells[0][:1].isdigit()])
    time, force, stroke = rows[: rows[:, 1].argmax() : every].T
    return {"time_s": time, "stroke_mm": stroke, "force_n": force}
