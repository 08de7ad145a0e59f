"""Files of the package mulensmodel, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import mulensmodel


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_exposures_of_two_fields_go_together_where_they_follow_soon_and_are_sharp(self):
        first = b"1.000 18.0 0.01\n2.000 18.1 0.01\n3.000 18.2 0.90\n"
        second = b" 1.010 17.9 0.02\n 2.200 18.0 0.02\n 3.001 18.1 0.02\n 1.990 18.3 0.02\n"
        read = mulensmodel.two_fields(first, second, apart=1000, worst=0.1)
        self.assertEqual(told(read), {"time_s": [0, 84672], "first_mag": [18, 18.1], "second_mag": [17.9, 18.3]})


if __name__ == "__main__":
    unittest.main()
