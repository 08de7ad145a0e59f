"""Files of the package tribology, read from small ones that are made here."""

import unittest

from tests.made import READS

if READS:
    import numpy as np
    from readers import tribology as read


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_rows_end_as_on_an_old_machine(self):
        places, heights = read.profile(b"0\t-234.2\r0.0017\t-1.5\r")
        self.assertEqual((places.tolist(), heights.tolist()), ([0, 0.0017], [-234.2, -1.5]))

    def test_rows_are_kept_where_every_height_is_near_the_top(self):
        one, other = np.array([-50.0, -1, 0, -2, -9]), np.array([-3.0, -4, -60, -5, -6])
        kept = read.near_top(np.arange(5.0), one, other, below=10, every=2)
        self.assertEqual([part.tolist() for part in kept], [[1, 4], [-1, -9], [-4, -6]])


if __name__ == "__main__":
    unittest.main()
