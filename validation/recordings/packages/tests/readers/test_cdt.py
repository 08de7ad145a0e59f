"""Files of the package cdt, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import cdt

PAIRS = b"SampleID,A,B\npair1, 1.0 2.0 3.0, 4.0 5.0 6.0\npair2, 7.0 8.0 9.0, 1.5 2.5 3.5\n"


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_columns_of_two_pairs(self):
        self.assertEqual(told(cdt.pair_columns(PAIRS, x=("pair2", "A"), y=("pair1", "B"))), {"x": [7, 8, 9], "y": [4, 5, 6]})
        self.assertEqual(told(cdt.pair_columns(PAIRS, step=60, rows=2, x=("pair2", "B"))), {"time_s": [0, 60], "x": [1.5, 2.5]})


if __name__ == "__main__":
    unittest.main()
