"""Reads files of the package evo."""

import numpy as np


def poses(content):
    """Places of a camera, one a picture, from the last column of the first three rows of each pose."""
    return np.array([[float(v) for v in line.split()] for line in content.decode().splitlines()])[:, [3, 7, 11]]


def track(content):
    """Times, places and turns of a camera, one row each; lines that begin with # are comments."""
    return np.array([[float(v) for v in line.split()] for line in content.decode().splitlines() if line[:1] != "#"])
