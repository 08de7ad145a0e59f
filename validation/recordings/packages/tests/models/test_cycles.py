"""Waves of a day in columns that are made here."""

import unittest

import numpy as np
from tests.made import SCIPY, left_by

if SCIPY:
    from models import cycles


@unittest.skipUnless(SCIPY, "scipy is not installed")
class Models(unittest.TestCase):
    def test_three_waves_of_a_day_are_found_beside_a_bend(self):
        t, rng = np.arange(0, 8 * 86400, 3600.0), np.random.default_rng(1)
        x = rng.normal(size=len(t))
        left = left_by(2 * x + x**2 + np.sin(6 * np.pi * t / 86400), cycles.waves_of_day(2 * x + x**2 + np.sin(6 * np.pi * t / 86400), x, t))
        self.assertLess(left["day, and square"], 1e-9)
        self.assertGreater(left["day"], 0.5)
        self.assertGreater(left["two waves a day"], left["day"])


if __name__ == "__main__":
    unittest.main()
