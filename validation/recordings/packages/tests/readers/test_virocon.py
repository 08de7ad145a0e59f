"""Files of the package virocon, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import virocon

BUOY = b"time (YYYY-MM-DD-HH); height (m); period (s)\n1996-01-01-00; 0.5; 4\n1996-01-01-01; 0.6; 5\n1996-01-01-04; 0.7; 6\n"


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_hours_that_a_buoy_leaves_out_stay_on_the_clock(self):
        self.assertEqual(told(virocon.buoy(BUOY, 2)), {"time_s": [0, 14400], "height_m": [0.5, 0.7], "period_s": [4, 6]})


if __name__ == "__main__":
    unittest.main()
