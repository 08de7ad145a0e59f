"""Files of the package aquacrop, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import aquacrop


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_evaporation_is_read_from_a_year_to_before_another(self):
        lines = "1 1 2011 0 9 0 9\n31 12 2012 0 1 0 2\n1 1 2013 0 9 0 9\n2 1 2013 0 3 0 4\n1 1 2014 0 9 0 9\n"
        read = aquacrop.evaporation(f"Day Month Year Tmin(C) Tmax(C) Prcp(mm) Et0(mm)\n{lines}".encode(), 2012, 2014, 2)
        self.assertEqual(told(read), {"time_s": [0, 172800], "warmest_degc": [1, 3], "evaporation_mm": [2, 4]})


if __name__ == "__main__":
    unittest.main()
