"""Rows taken together."""

import unittest

import numpy as np
from tests.made import READS

if READS:
    from formats import rows


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_what_turns_adds_up_from_the_first_row_on(self):
        self.assertEqual(rows.summed(np.array([0.0, 2, 2]), np.array([0.0, 1, 3])).tolist(), [0, 1, 5])


if __name__ == "__main__":
    unittest.main()
