"""A file of the package pydicom, read from a small one that is made here."""

import struct
import unittest

from tests.made import READS, told

if READS:
    import numpy as np
    from readers import pydicom as read


def element(group, number, kind, value):
    """An element with its length."""
    long = kind in read.LONG
    return struct.pack("<HH2s", group, number, kind) + struct.pack("<HI" if long else "<H", *([0] if long else []), len(value)) + value


def sequence(group, number):
    """The begin of a sequence without a length, and of its first item."""
    return struct.pack("<HH2sHI", group, number, b"SQ", 0, 0xFFFFFFFF) + struct.pack("<HHI", 0xFFFE, 0xE000, 0xFFFFFFFF)


def lead(name, step):
    return element(0x0008, 0x0104, b"LO", name) + element(0x003A, 0x0210, b"DS", step) + element(0x0008, 0x0104, b"LO", b"microvolt ")


def heart(rows):
    """Two leads, and a second group of rows that is not read."""
    data = [element(0x5400, 0x1010, b"OW", np.array(values, "<i2").tobytes()) for values in (rows, [[7, 7]])]
    inside = sequence(0x5400, 0x0100) + lead(b"Lead I (Einthoven)", b"2.5 ") + lead(b"Lead V2 ", b"1 ") + data[0] + lead(b"Lead I ", b"1 ") + data[1]
    return b"\0" * 128 + b"DICM" + element(0x0008, 0x0060, b"CS", b"ECG ") + inside


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_elements_inside_of_sequences_are_found(self):
        tags = [tag for tag, _ in read.elements(heart([[1, 2]]))]
        self.assertEqual(tags[:3], [(0x0008, 0x0060), read.NAME, read.STEP])
        self.assertEqual(tags.count(read.DATA), 2)

    def test_leads_are_in_microvolt_by_their_names(self):
        read_leads = told(read.leads(heart([[4, 1], [5, 2], [6, 3]]), 2, first_uv="I", second_uv="V2"))
        self.assertEqual(read_leads, {"time_s": [0, 0.002], "first_uv": [10, 15], "second_uv": [1, 3]})


if __name__ == "__main__":
    unittest.main()
