"""Files of the package aqeval, read from small ones that are made here."""

import gzip
import unittest

from tests.made import READS, told

if READS:
    from readers import aqeval


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_days_of_a_road_that_lack_something_are_left_out(self):
        content = gzip.compress(b"date,no2,bg.no2,ws,wd\n2001-01-01 00:00:00,4,1,2,9\n2001-01-01 12:00:00,6,3,4,9\n2001-01-02 00:00:00,5,,1,9\n2001-01-03 00:00:00,7,5,6,9\n")
        self.assertEqual(told(aqeval.road(content)), {"time_s": [0, 172800], "background": [2, 5], "wind_m_s": [3, 6], "road": [5, 7]})


if __name__ == "__main__":
    unittest.main()
