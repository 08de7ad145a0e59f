"""Files of the package fpex0, read from small ones that are made here."""

import json
import unittest

from tests.made import READS, told

if READS:
    from readers import fpex0


def warmed(rate, warmth, taken):
    """A file of a calorimeter."""
    return json.dumps({"ID": "x", "rate": rate, "T": warmth, "latentdata": taken}).encode()


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_sample_that_is_warmed_twice(self):
        fast, slow = warmed(20, [9, 10, 12, 14], [0, 1, 2, 3]), warmed(2, [9, 11, 13, 15], [0, 20, 40, 60])
        self.assertEqual(told(fpex0.melting(fast, slow, 9.5, 20)), {"time_s": [0, 6, 12], "slow_j_gk": [10, 30, 50], "fast_j_gk": [1, 2, 3]})


if __name__ == "__main__":
    unittest.main()
