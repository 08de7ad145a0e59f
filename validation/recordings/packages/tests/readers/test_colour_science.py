"""Files of the package colour-science, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import colour_science


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_patches_are_read_at_the_wavelengths_that_both_charts_have(self):
        first, second = b"wavelength,1,2\n380,0.1,0.2\n385,9,9\n390,0.3,0.4\n", b"wavelength,1,2\n380,0.5,0.6\n390,0.7,0.8\n400,9,9\n"
        read = colour_science.two_charts(first, second)
        self.assertEqual(told(read), {"run": [1, 1, 2, 2], "nm": [380, 390, 380, 390], "first": [0.1, 0.3, 0.2, 0.4], "second": [0.5, 0.7, 0.6, 0.8]})


if __name__ == "__main__":
    unittest.main()
