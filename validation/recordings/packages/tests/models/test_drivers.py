"""Drivers in columns that are made here."""

import unittest

import numpy as np
from tests.made import SCIPY, left_by

if SCIPY:
    from models import drivers


@unittest.skipUnless(SCIPY, "scipy is not installed")
class Models(unittest.TestCase):
    def test_two_drivers_are_found_beside_one_another(self):
        x, a, b = np.random.default_rng(2).normal(size=(3, 200))
        left = left_by(x + 2 * a - b, drivers.two_drivers(x + 2 * a - b, x, a=a, b=b))
        self.assertLess(left["a and b"], 1e-9)

    def test_drivers_are_found_beside_a_drift(self):
        t = np.arange(200.0)
        x, a, b = np.random.default_rng(4).normal(size=(3, 200))
        left = left_by(x + 2 * a + 0.1 * t, drivers.drivers_and_drift(x + 2 * a + 0.1 * t, x, t, a=a, b=b))
        self.assertLess(left["a, and drift"], 1e-9)
        self.assertLess(left["all squares of a, and drift"], 1e-9)
        self.assertGreater(left["b, and drift"], 1)

    def test_gains_by_two_drivers_are_found_beside_one_another(self):
        x, a, b = np.random.default_rng(3).normal(size=(3, 200))
        left = left_by(x * (2 + a - b), drivers.gains(x * (2 + a - b), x, a=a, b=b))
        self.assertLess(left["gains by a and b"], 1e-9)
        self.assertGreater(left["gain by a"], 0.5)


if __name__ == "__main__":
    unittest.main()
