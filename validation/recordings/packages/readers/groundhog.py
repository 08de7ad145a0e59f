"""Reads files of the package groundhog."""

import numpy as np


def cone_test(content, deepest):
    """Rows of a cone that is pushed into the ground, one each 0.02 m, from where its sleeve is in the ground on: depth in m, resistance and friction in MPa."""
    rows = [line.split() for line in content.decode("latin1").splitlines()]
    table = np.array([row for row in rows if len(row) == 10 and row[0].isdigit()], float)
    table = table[(table[:, 1] > 0.1) & (table[:, 1] <= deepest)]
    return {"depth_m": table[:, 1], "cone_mpa": table[:, 3], "sleeve_mpa": table[:, 6]}
