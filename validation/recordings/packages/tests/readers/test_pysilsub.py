"""Files of the package pysilsub, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import pysilsub

LAMPS = b"Primary,Setting,380,381\n0,0,1,2\n0,65,3,4\n1,0,5,6\n1,65,7,8\n"
OTHERS = b"Primary,Setting,380,381\n0,0,1,1\n0,65,2,2\n1,0,3,3\n1,65,4,5\n"


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_lamp_has_all_its_wavelengths_together(self):
        self.assertEqual(told(pysilsub.lamp_by_setting(LAMPS, 1)), {"setting": [0, 65], "light": [11, 15]})
        self.assertEqual(told(pysilsub.two_lamps(LAMPS, OTHERS, 0)), {"first": [3, 7], "second": [2, 4]})


if __name__ == "__main__":
    unittest.main()
