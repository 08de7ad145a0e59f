"""Reads files of the package pylook."""

import struct

import numpy as np
from formats.clock import elapsed

# what a step of the press's converters is, as those who ran it wrote it down
SLIP_UM, SHEAR_MPA, LAYER_UM = 0.076472, 1.597778959e-3, 0.11017176


def rock_press(content, beside, first, last, every):
    """Each so many rows of a press that shears rock: seconds since the first, slip, and beside it shear stress or thickness of the layer, each from a zero of its own."""
    rows, columns = struct.unpack(">ii", content[20:28])
    table = np.frombuffer(content, ">f4", rows * columns, len(content) - 4 * rows * columns).reshape(columns, rows).astype(float)
    _, slip, shear, layer, _ = table[:, first:last:every]
    told = {"shear_mpa": shear * SHEAR_MPA, "layer_um": layer * LAYER_UM}
    return {"time_s": elapsed(np.cumsum(table[0] / 10000)[first:last:every]), "slip_um": slip * SLIP_UM, beside: told[beside]}
