"""Files of the package pcse, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import pcse

FARM = b"""* 1989 a comment of nine words that is left away here
   5.67  51.97     7.  -0.18 -0.55
   1 1992   1   350.   3.6   8.1   0.800   5.8   0.0
   1 1992   2   760.   5.5   7.3   0.790   6.3   0.0
"""


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_days_of_a_farm(self):
        read = told(pcse.farm_days(FARM, FARM.replace(b" 1992   1", b" 1993   1").replace(b" 1992   2", b" 1993   2")))
        self.assertEqual(read["time_s"], [0, 86400, 366 * 86400, 367 * 86400])
        self.assertEqual([values[:2] for values in read.values()][1:], [[3.6, 5.5], [0.35, 0.76], [0.8, 0.79], [8.1, 7.3]])


if __name__ == "__main__":
    unittest.main()
