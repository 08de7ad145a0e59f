"""Least squares against closed forms."""

import unittest

import numpy as np
from tests.made import SCIPY

if SCIPY:
    from models import fitting


@unittest.skipUnless(SCIPY, "scipy is not installed")
class Fits(unittest.TestCase):
    def setUp(self):
        self.x = np.linspace(0, 4, 41)
        self.seen = self.x < 3

    def test_rows_that_may_not_be_seen_have_no_say(self):
        y = 2 + 3 * self.x
        wrong = np.where(self.seen, y, 1e6)
        self.assertLess(np.abs(fitting.line(wrong, self.x)(self.seen) - y).max(), 1e-10)

    def test_numbers_inside_of_terms_are_found(self):
        y = 1 + 5 * np.exp(-self.x / 0.7)
        model = fitting.terms(y, lambda p: [np.exp(-self.x / abs(p[0]))], [0.5])
        self.assertLess(np.abs(model(self.seen) - y).max(), 1e-6)

    def test_through_zero_there_is_no_constant(self):
        # least squares of 1 on x: sum(x) / sum(x^2) times x
        slope = self.x.sum() / (self.x**2).sum()
        model = fitting.through_zero(np.ones(41), self.x)
        self.assertLess(np.abs(model(np.ones(41, bool)) - slope * self.x).max(), 1e-12)


if __name__ == "__main__":
    unittest.main()
