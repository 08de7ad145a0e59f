"""Lags against closed forms; shifts, lags and play in columns that are made here."""

import unittest

import numpy as np
from tests.made import SCIPY

if SCIPY:
    from models import lags


@unittest.skipUnless(SCIPY, "scipy is not installed")
class Models(unittest.TestCase):
    def test_a_lag_answers_a_step_by_an_exponential_with_even_rows_and_without(self):
        for t in (np.arange(60) * 0.5, np.cumsum(np.tile([0.4, 0.6], 30))):
            u = (np.arange(60) > 0) * 1.0
            u[0] = 1.0
            u = np.r_[0.0, u]
            time = np.r_[-1e-9, t - t[0]]
            out = lags.lag(u, time, 3.0)
            self.assertLess(np.abs(out[1:] - (1 - np.exp(-(t - t[0]) / 3.0))).max(), 1e-6)

    def test_a_lag_follows_a_ramp_behind_by_its_time(self):
        # of u = t, from rest: t - tau + tau exp(-t / tau); between rows the mean is taken, which errs by less than dt^2
        t, tau = np.arange(0, 20, 0.1), 3.0
        self.assertLess(np.abs(lags.lag(t, t, tau) - (t - tau + tau * np.exp(-t / tau))).max(), 0.01)

    def test_memory_starts_afresh_in_each_run(self):
        run, t, x = np.array([1, 1, 2, 2]), np.array([0.0, 1, 5, 7]), np.array([1.0, 2, 3, 4])
        self.assertEqual(lags.in_runs(run, t, lambda rows, s: s).tolist(), [0, 1, 0, 2])
        self.assertEqual(lags.in_runs(run, t, lambda rows, s: x[rows] - x[rows][0]).tolist(), [0, 1, 0, 1])

    def test_play_stands_until_it_is_pushed_or_pulled(self):
        self.assertEqual(lags.play(np.array([0.0, 0.5, 3, 2, 0]), 1).tolist(), [0, 0, 2, 2, 1])

    def test_a_shift_that_changes_is_found(self):
        t = np.arange(400.0)
        x, late = np.sin(t / 9), lambda by: np.sin((t - by) / 9)
        y = 3 + 2 * late(5 - 2 * (t / t[-1] - 0.5))
        models, seen = lags.late_shifts(y, x, t, 1, 4.0), t > 30
        error = {name: np.abs(models[name](seen) - y)[seen].max() for name in ("shift from there", "shift that changes")}
        self.assertLess(error["shift that changes"], 0.02)
        self.assertGreater(error["shift from there"], 0.1)

    def test_a_lag_is_found_beside_others(self):
        t = np.arange(400.0)
        x = np.sin(t / 7) + np.sin(t / 31)
        y = 2 * lags.lag(x, t, 12) + 1
        seen = np.ones(400, bool)
        left = {name: np.std(y - model(seen)) for name, model in lags.behind(y, x, t, 10).items()}
        self.assertLess(left["lag, and square"], 1e-3)
        self.assertLess(left["line, and lag"], 1e-3)

    def test_a_shift_is_found_beside_a_term_either_way(self):
        t = np.arange(0, 20, 0.1)
        x, term, seen = np.sin(t), np.cos(3 * t), np.ones(200, bool)
        for by in (0.3, -0.3):
            y = 2 * np.interp(t - by, t, x) + term + 1
            models = lags.usual_and_shifts(y, x, t, 0.5, term=term)
            self.assertLess(np.abs(models["shift, and term"](seen) - y).max(), 1e-6)
            self.assertGreater(np.abs(models["term"](seen) - y).max(), 0.1)


if __name__ == "__main__":
    unittest.main()
