"""Files of the package gtsam, read from small ones that are made here."""

import unittest

import numpy as np
from tests.made import READS, matlab, told

if READS:
    from readers import gtsam


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_radio_is_as_far_as_the_robot_is_from_it(self):
        way = np.array([[10.0, 0, 0, 0], [12, 6, 8, 0]])
        heard = np.array([[12.0, 2, 7, 11], [10, 2, 7, 1], [11, 2, 5, 4]])
        read = gtsam.radio_ranges(matlab(GT=way, TD=heard, TL=np.array([[7.0, 0, 0], [5, 3, 0]])))
        self.assertEqual(told(read), {"time_s": [0, 1, 2], "apart_m": [0, 4, 10], "radio_m": [1, 4, 11]})


if __name__ == "__main__":
    unittest.main()
