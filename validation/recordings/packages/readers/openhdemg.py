"""Reads files of the package openhdemg."""

import numpy as np
from formats.matlab import variables
from formats.rows import means


def muscle(content, electrodes, hertz, every):
    """A muscle that pushes: seconds, how loud its electrodes are in uV as a mean of their root mean squares over some readings, and the force as a mean of these, in per cent of the most."""
    table = variables(content)["Data"][0, 0]
    rows = len(table) // every * every
    loud = table[:rows, :electrodes] - table[:, :electrodes].mean(axis=0)
    loud = np.sqrt((loud.reshape(-1, every, electrodes) ** 2).mean(axis=1)).mean(axis=1)
    return {"time_s": (np.arange(len(loud)) * every / hertz).round(4), "loud_uv": loud.round(4), "force_pct": means(table[:rows, -1], every).round(4)}
