"""Least squares and lags against closed forms."""

import importlib.util
import unittest

import numpy as np

SCIPY = importlib.util.find_spec("scipy")
if SCIPY:
    import fitting


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

    def test_a_lag_answers_a_step_by_an_exponential_with_even_rows_and_without(self):
        for t in (np.arange(60) * 0.5, np.cumsum(np.tile([0.4, 0.6], 30))):
            u = (np.arange(60) > 0) * 1.0
            u[0] = 1.0
            u = np.r_[0.0, u]
            time = np.r_[-1e-9, t - t[0]]
            out = fitting.lag(u, time, 3.0)
            self.assertLess(np.abs(out[1:] - (1 - np.exp(-(t - t[0]) / 3.0))).max(), 1e-6)

    def test_a_lag_follows_a_ramp_behind_by_its_time(self):
        # of u = t, from rest: t - tau + tau exp(-t / tau); between rows the mean is taken, which errs by less than dt^2
        t, tau = np.arange(0, 20, 0.1), 3.0
        self.assertLess(np.abs(fitting.lag(t, t, tau) - (t - tau + tau * np.exp(-t / tau))).max(), 0.01)


if __name__ == "__main__":
    unittest.main()
