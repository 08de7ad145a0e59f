"""Files of the package faraway, read from small ones that are made here."""

import bz2
import unittest

from tests.made import READS, told

if READS:
    from readers import faraway

BOOK = bz2.compress(b'"Field","Lab","Batch"\n18,20.2,"1"\n38,56,"2"\n')


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_packed_table(self):
        self.assertEqual(told(faraway.book_table(BOOK, run="Batch", lab="Lab")), {"run": [1, 2], "lab": [20.2, 56]})


if __name__ == "__main__":
    unittest.main()
