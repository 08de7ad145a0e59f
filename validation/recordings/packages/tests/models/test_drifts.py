"""Models of drifts, on columns that are made here."""

import unittest

import numpy as np
from tests.made import READS, left_by

if READS:
    from models import drifts


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Models(unittest.TestCase):
    def test_a_drift_by_the_logarithm_and_one_to_a_rest_are_found(self):
        t, x = np.arange(0.0, 2000.0, 10), np.random.default_rng(4).normal(size=200)
        self.assertLess(left_by(2 * x + np.log(t + 10), drifts.usual_shifts_and_drifts(2 * x + np.log(t + 10), x, t, 10))["drift by the logarithm"], 1e-9)
        self.assertLess(left_by(2 * x + np.exp(-t / 500), drifts.usual_shifts_and_drifts(2 * x + np.exp(-t / 500), x, t, 10))["drift to a rest"], 1e-6)

    def test_a_course_of_the_clock_alone_is_found(self):
        t = np.arange(0.0, 2000.0, 10)
        of = lambda y: left_by(y, drifts.courses(y, t))
        self.assertLess(of(np.exp(-t / 500))["drift to a rest"], 1e-6)
        self.assertLess(of(t / 500 + (t > 900))["drift, and step"], 1e-9)
        self.assertGreater(of(t / 500 + (t > 900))["step"], 0.1)


if __name__ == "__main__":
    unittest.main()
