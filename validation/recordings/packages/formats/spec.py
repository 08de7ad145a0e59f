"""Logs of a beamline (SPEC)."""

import re

import pandas as pd


def scans(content):
    """The scans of a SPEC file, each as a data frame with the number of its scan; of two columns of one name the last."""
    for scan in re.split(r"\n(?=#S )", content.decode("latin1"))[1:]:
        labels = re.search(r"^#L (.*)$", scan, re.M)
        names = re.split(r"\s{2,}", labels[1].strip()) if labels else []
        cells = [line.split() for line in scan.splitlines() if line[:1] in "-0123456789" and line]
        kept = [[float(v) for v in row] for row in cells if len(row) == len(names)]
        frame = pd.DataFrame(kept, columns=names)
        yield frame.loc[:, ~frame.columns.duplicated(keep="last")].assign(scan=int(scan.split()[1]))
