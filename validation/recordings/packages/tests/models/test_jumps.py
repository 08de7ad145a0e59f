"""A zero or a slope that is another from some time on."""

import unittest

import numpy as np
from tests.made import SCIPY

if SCIPY:
    from models import fitting, jumps


@unittest.skipUnless(SCIPY, "scipy is not installed")
class Models(unittest.TestCase):
    def test_a_step_takes_what_was_switched(self):
        t = np.arange(50.0)
        x = np.cos(t)
        y = x + 3 * (t > 20)
        seen = np.ones(50, bool)
        self.assertLess(np.abs(jumps.switched_at(y, x, t, 20)["step"](seen) - y).max(), 1e-9)
        self.assertGreater(np.abs(fitting.line(y, x)(seen) - y).max(), 1)

    def test_a_zero_that_changes_is_found_where_it_does(self):
        t, rng = np.arange(400.0), np.random.default_rng(1)
        x = rng.uniform(1, 2, 400)
        y = 2 * x + 3 * (t > 250)
        seen = np.ones(400, bool)
        self.assertLess(np.std(y - jumps.changed(y, t, [x], np.ones(400))(seen)), 1e-9)
        self.assertGreater(np.std(y - jumps.changed(y, t, [x], x)(seen)), 0.01)


if __name__ == "__main__":
    unittest.main()
