"""Files of the package orange-spectroscopy, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import orange_spectroscopy


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_one_kind_of_tissue_near_some_wavenumbers(self):
        content = b"type,1700.0,1650.0,1600.0\nd,c,c,c\nclass,,,\ncollagen,0.1,0.2,0.3\nDNA,1,1,1\ncollagen,0.4,0.5,0.6\n"
        self.assertEqual(told(orange_spectroscopy.tissue(content, "collagen", one=1655, two=1540)), {"one": [0.2, 0.5], "two": [0.3, 0.6]})


if __name__ == "__main__":
    unittest.main()
