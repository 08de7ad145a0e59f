"""Corners and powers in columns that are made here."""

import unittest

import numpy as np
from tests.made import SCIPY, left_by

if SCIPY:
    from models import bends


@unittest.skipUnless(SCIPY, "scipy is not installed")
class Models(unittest.TestCase):
    def test_a_corner_and_a_power_are_found(self):
        x = np.linspace(0.1, 10, 100)
        self.assertLess(left_by(2 * x - np.maximum(x - 6, 0), bends.levels_off(2 * x - np.maximum(x - 6, 0), x, 5.0))["corner"], 0.01)
        self.assertLess(left_by(3 * x**0.6, bends.levels_off(3 * x**0.6, x, 5.0))["power"], 1e-6)


if __name__ == "__main__":
    unittest.main()
