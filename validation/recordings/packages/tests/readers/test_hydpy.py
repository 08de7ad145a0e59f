"""Files of the package hydpy, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import hydpy

DAYS = b'Timegrid("1989-11-01 00:00:00+01:00",\n         "2021-01-01 00:00:00+01:00",\n         "1d")\n5.5\n6.5\n7.5\n8.5\n'


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_days_begin_behind_a_head(self):
        read = hydpy.valley(DAYS, DAYS, first=1, days=2, names=("rain", "water"))
        self.assertEqual(told(read), {"time_s": [0, 86400], "rain": [6.5, 7.5], "water": [6.5, 7.5]})


if __name__ == "__main__":
    unittest.main()
