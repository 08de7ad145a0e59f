"""Reads files of the package pycomlink."""

import numpy as np
from formats.netcdf import dataset, filled


def link_loss(content, link):
    """Loss of one microwave link in dB, means of 5 min, one row for each of its two channels; what was not measured is nan."""
    with dataset(content) as file:
        sent, got = (filled(file[name])[:, link, :] for name in ("tsl", "rsl"))
    loss = np.where(np.abs(sent - got) < 200, sent - got, np.nan)
    return loss.reshape(2, -1, 5).mean(axis=2)
