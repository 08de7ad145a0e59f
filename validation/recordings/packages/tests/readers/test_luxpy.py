"""Files of the package luxpy, read from small ones that are made here."""

import unittest

from tests.made import READS, written

if READS:
    from readers import luxpy


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_darkness_is_found_by_its_exposure(self):
        content = written([[0, 400, 401], [0.003, 10, 11], [2, 20, 22]])
        self.assertEqual([list(counts) for counts in luxpy.darkness(content, 2, 0.003)], [[20, 22], [10, 11]])


if __name__ == "__main__":
    unittest.main()
