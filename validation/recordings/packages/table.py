"""Tables of numbers: columns by name, written and read as CSV."""

import csv
import io
import os
from pathlib import Path

import numpy as np

from problem import Problem


def text(columns, digits):
    """Columns as CSV: whole numbers as they are, other numbers with so many digits."""
    arrays = {name: np.asarray(values) for name, values in columns.items()}
    rows = {len(values) for values in arrays.values()}
    if len(rows) != 1:
        raise Problem(f"columns have different numbers of rows: {sorted(rows)}")
    cells = [[cell(v, digits) for v in values.tolist()] for values in arrays.values()]
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(arrays)
    writer.writerows(zip(*cells))
    return out.getvalue()


def cell(value, digits):
    """One number as text; a missing one is an empty cell."""
    if isinstance(value, int):
        return str(value)
    return "" if value != value else f"{value:.{digits}g}"


def read(path):
    """The columns of a CSV of numbers; an empty cell is nan."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            header, *rows = csv.reader(file)
        return {name: np.array([float(row[k] or "nan") for row in rows]) for k, name in enumerate(header)}
    except OSError as error:
        raise Problem(f"{path}: {error.strerror}") from error
    except (ValueError, IndexError) as error:
        raise Problem(f"{path} is no table of numbers: {error}") from error


def put(path, header, lines):
    """A table as CSV, into a file, or onto the screen where none is named."""
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows([header, *lines])
    if path:
        write(path, out.getvalue())
    else:
        print(out.getvalue(), end="")


def write(path, content):
    """Writes a file whole or not at all."""
    path = Path(path)
    part = path.with_name(path.name + ".part")
    try:
        part.write_text(content, encoding="utf-8", newline="")
        os.replace(part, path)
    except OSError as error:
        part.unlink(missing_ok=True)
        raise Problem(f"{path} cannot be written: {error.strerror}") from error
