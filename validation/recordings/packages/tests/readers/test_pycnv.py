"""Files of the package pycnv, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import pycnv

BOTTLES = b"""* heading (avg)x
  Btl_Posn        Date       PrDM    C0mS/cm
      1    Feb 26 2018     10.25   7.5 (avg)
     27       08:32:41      0.219   0.1 (sdev)
      2    Feb 26 2018     20.5   8.5 (avg)
"""


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_bottles_of_two_casts(self):
        read = pycnv.bottles(BOTTLES, BOTTLES, dbar=0, ms_cm=1)
        self.assertEqual(told(read), {"run": [1, 1, 2, 2], "dbar": [10.25, 20.5, 10.25, 20.5], "ms_cm": [7.5, 8.5, 7.5, 8.5]})


if __name__ == "__main__":
    unittest.main()
