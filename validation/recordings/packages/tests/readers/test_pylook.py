"""Files of the package pylook, read from small ones that are made here."""

import struct
import unittest

import numpy as np
from tests.made import READS, told

if READS:
    from readers import pylook


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_press_is_read_in_steps_of_its_converters(self):
        table = np.array([[10000, 10000, 5000, 5000], [0, 100, 200, 300], [0, 1000, 2000, 3000], [0, 10, 20, 30], [0, 0, 0, 0]], ">f4")
        content = b"p1".ljust(20, b"\0") + struct.pack(">ii", 4, 5) + b"\0" * 100 + table.tobytes()
        for beside, values in (("shear_mpa", [1.597779, 4.793337]), ("layer_um", [1.101718, 3.305153])):
            read = told(pylook.rock_press(content, beside, first=1, last=4, every=2))
            self.assertEqual(read, {"time_s": [0, 1], "slip_um": [7.6472, 22.9416], beside: values})


if __name__ == "__main__":
    unittest.main()
