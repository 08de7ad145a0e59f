"""Files of the package chemotools, read from small ones that are made here."""

import unittest

from tests.made import READS, told, written

if READS:
    from readers import chemotools


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_band_is_the_one_that_is_next_to_a_wavenumber(self):
        read = chemotools.bands(written([[1000, 1003, 1006], [1, 2, 3], [4, 5, 6]]), 75, 1004, 1000)
        self.assertEqual(told(read), {"time_s": [0, 75], "band_1004": [2, 5], "band_1000": [1, 4]})


if __name__ == "__main__":
    unittest.main()
