"""Files of the package opsdata-coal-node, read from small ones that are made here."""

import struct
import unittest

import numpy as np
from tests.made import READS, told

if READS:
    from readers import opsdata_coal_node


def record(station, channel, values):
    """One record of miniSEED with floating numbers, 256 bytes long."""
    head = bytearray(64)
    head[8:20] = f"{station:5}1 {channel}1 ".encode()
    struct.pack_into(">H", head, 30, len(values))
    struct.pack_into(">H", head, 44, 64)
    head[54] = 8
    return (bytes(head) + np.array(values, ">f4").tobytes()).ljust(256, b"\0")


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_vertical_channels_of_two_geophones(self):
        content = record("5", "DPZ", [1, 2]) + record("5", "DPE", [9, 9]) + record("12", "DPZ", [5, 6]) + record("5", "DPZ", [3, 4]) + record("12", "DPZ", [7, 8])
        self.assertEqual(told(opsdata_coal_node.geophones(content, 3, 250, nearer="5", farther="12")), {"time_s": [0, 0.004, 0.008], "nearer": [1, 2, 3], "farther": [5, 6, 7]})


if __name__ == "__main__":
    unittest.main()
