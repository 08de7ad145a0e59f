"""Text files of numbers, on small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from formats import text


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_columns_get_the_names_that_they_are_to_have(self):
        self.assertEqual(told(text.columns(b"a,b,c\n1,2,3\n4,5,6\n7,8,9\n", 2, first="c", second="a")), {"first": [3, 6], "second": [1, 4]})


if __name__ == "__main__":
    unittest.main()
