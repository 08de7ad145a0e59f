"""Reads files of the package allantools."""

import numpy as np


def numbers(content):
    """One number a line; lines that begin with # are comments."""
    return np.array([float(line) for line in content.decode().splitlines() if line[:1] != "#"])
