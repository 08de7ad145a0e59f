"""Reads files of the package ismn."""

import pandas as pd
from formats.clock import seconds


def moisture(content, first, last):
    """Soil moisture between two times, and seconds since the first row."""
    cells = [row.split() for row in content.decode().splitlines()]
    frame = pd.DataFrame({"time": pd.to_datetime([" ".join(row[:2]) for row in cells]), "moisture": [float(row[12]) for row in cells]})
    frame = frame[frame.time.between(first, last)]
    return frame.assign(time_s=seconds(frame.time))
