"""Reads files of the package polartools."""

import re

import pandas as pd
from formats.clock import since_first


def spec_scans(content, *scans):
    """Scans of a beamline's log by their numbers, one after another, with seconds since the first point."""
    rows, names, number = [], [], None
    for line in content.decode("latin1").splitlines():
        if line.startswith("#S "):
            number = int(line.split()[1])
        elif line.startswith("#L "):
            names = re.split(r"  +", line[3:].strip())
        elif number in scans and line[:1].isdigit() and len(line.split()) == len(names):
            rows.append(dict(zip(names, map(float, line.split()))))
    frame = pd.DataFrame(rows)
    return frame.assign(time_s=since_first(frame.Epoch).round(3))
