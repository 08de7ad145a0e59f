"""Rows taken together: means, sums over time, numbers of runs."""

import numpy as np


def means(values, rows):
    """Means of so many values each; a rest at the end is left away."""
    values = np.asarray(values, float)
    return values[: len(values) // rows * rows].reshape(-1, rows).mean(axis=1)


def summed(rates, seconds):
    """What something that goes at these rates has come to by each row, straight between rows."""
    return np.append(0, np.cumsum(np.diff(seconds) * (rates[1:] + rates[:-1]) / 2))


def charged(amp, seconds):
    """Ah that a current has brought by each row."""
    return summed(amp, seconds) / 3600


def numbered(tables):
    """The run of each row of tables that lie one behind the other, from 1 on."""
    return np.repeat(np.arange(1, len(tables) + 1), [len(table) for table in tables])
