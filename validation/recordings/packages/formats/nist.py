"""Files of the NIST Statistical Reference Datasets."""

import numpy as np


def nist(content, columns):
    """The data of a file of the NIST Statistical Reference Datasets."""
    lines = content.decode().splitlines()
    start = max(k for k, line in enumerate(lines) if line.startswith("Data:")) + 1
    values = np.array([[float(v) for v in line.split()] for line in lines[start:] if line.strip()])
    return dict(zip(columns, values.T))
