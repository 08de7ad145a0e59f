"""Files of the package iadpython, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import iadpython

SKIN = (
    "Skin\x93,,,,,,,,,\n,Person 1,,,Person 2,,,,,\nWavelength (nm),R1,R2,Average,R1,R2,Average,,,\n"
    "250,0.1,0.2,0.15,0.3,0.4,0.35,,,\n260,0.5,0.6,0.55,0.7,0.8,0.75,,,\n270,0.9,1.0,0.95,1.1,1.2,1.15,,,\n"
).encode("latin1")


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_skin_is_a_row_for_each_time_that_a_person_was_seen(self):
        read = iadpython.skins(SKIN, times=2, short=251, long=272)
        self.assertEqual(told(read), {"run": [1, 1, 2, 2], "short": [0.1, 0.2, 0.3, 0.4], "long": [0.9, 1.0, 1.1, 1.2]})

    def test_skin_beside_skin(self):
        read = iadpython.skin_twice(SKIN, 2, 250, 270)
        self.assertEqual(told(read), {"run": [1, 1, 2, 2], "nm": [250, 270, 250, 270], "first": [0.1, 0.9, 0.3, 1.1], "second": [0.2, 1.0, 0.4, 1.2]})


if __name__ == "__main__":
    unittest.main()
