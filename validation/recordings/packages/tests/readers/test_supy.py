"""Files of the package supy, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import supy

TOWN = b"id it kdown Tair\n1 0 0 5\n1 1 10 6\n1 2 20 7\n1 3 30 8\n"


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_hours_of_a_town(self):
        self.assertEqual(told(supy.town(TOWN, 1, 2, sun="kdown", air="Tair")), {"time_s": [0, 3600], "sun": [10, 20], "air": [6, 7]})


if __name__ == "__main__":
    unittest.main()
