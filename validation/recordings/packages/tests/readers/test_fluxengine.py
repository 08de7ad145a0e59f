"""Files of the package fluxengine, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import fluxengine


SHIP = b"datetime\ttemperature\n2013-10-09 19:42:07\t1\n2013-10-09 19:53:07\t2\n2013-10-09 20:04:04\t3\n"


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_cruise_from_one_row_to_another(self):
        self.assertEqual(told(fluxengine.cruise(SHIP, 1, 3, sea="temperature")), {"time_s": [0, 657], "sea": [2, 3]})


if __name__ == "__main__":
    unittest.main()
