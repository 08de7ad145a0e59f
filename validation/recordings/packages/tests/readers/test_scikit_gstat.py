"""Files of the package scikit-gstat, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import scikit_gstat

BANK = b'"zinc","copper","om","soil"\n1,2,3,"1"\n4,5,,"1"\n6,7,8,"2"\n'


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_soil_with_a_gap_is_left_out(self):
        self.assertEqual(told(scikit_gstat.river_bank_soil(BANK, zinc_ppm="zinc", copper_ppm="copper")), {"zinc_ppm": [1, 6], "copper_ppm": [2, 7]})


if __name__ == "__main__":
    unittest.main()
