"""Reads files of the package sunpy."""

import re

import numpy as np

FITS_KINDS = {"D": ">f8", "E": ">f4", "J": ">i4", "I": ">i2", "B": "u1", "A": "S1", "L": "u1"}


def fits_tables(content):
    """Binary tables of a FITS file by their names, each an array with named fields."""
    at, found = 0, {}
    while at < len(content):
        end = at
        while not any(content[k : k + 8] == b"END     " for k in range(end, end + 2880, 80)):
            end += 2880
        end += 2880
        cards = [content[k : k + 80].decode("latin1") for k in range(at, end, 80)]
        told = {card[:8].strip(): card[10:].split(" /")[0].strip(" '") for card in cards if card[8:10] == "= "}
        axes = [int(told[f"NAXIS{k}"]) for k in range(1, int(told["NAXIS"]) + 1)]
        if told.get("XTENSION") == "BINTABLE":
            forms = [re.match(r"(\d*)([A-Z])", told[f"TFORM{k}"]) for k in range(1, int(told["TFIELDS"]) + 1)]
            kinds = [(told[f"TTYPE{k}"], FITS_KINDS[form[2]], (int(form[1] or 1),)) for k, form in enumerate(forms, 1)]
            found[told["EXTNAME"]] = np.frombuffer(content, np.dtype(kinds), axes[1], end)
        size = int(np.prod(axes)) * abs(int(told["BITPIX"])) // 8 if axes else 0
        at = end + -(-size // 2880) * 2880
    return found
