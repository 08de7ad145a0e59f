"""Laws against closed forms that share no code with them."""

import unittest
from pathlib import Path

import laws
import numpy as np

EFFECTS = Path(__file__).resolve().parents[4] / "docs" / "effects.md"


def rows(signal, seconds=1.0, driver=None):
    signal = np.asarray(signal, dtype=float)
    return laws.Rows(seconds * np.arange(len(signal)), signal, driver, 0.5)


class Laws(unittest.TestCase):
    def test_a_ramp_is_followed_behind_by_the_time_constant(self):
        time = np.linspace(0.0, 50.0, 400)
        exact = time - 4.0 + 4.0 * np.exp(-time / 4.0)
        np.testing.assert_allclose(laws.first_order(time, time, 4.0), exact, atol=1e-12)

    def test_a_slab_answers_a_step_at_first_as_the_root_of_the_time(self):
        # mean temperature of a slab of half thickness l: 2 / sqrt(pi) sqrt(a t / l^2), where l^2 / a = pi^2 / 4 slowest constants; five parts of the series have 96 % of all weights
        time = np.arange(0.0, 300.0, 0.05)
        late = laws.slab(np.r_[0.0, np.ones(len(time) - 1)], time, 100.0)
        at = np.searchsorted(time, 10.0)
        exact = 2.0 / np.sqrt(np.pi) * np.sqrt(10.0 / (100.0 * np.pi**2 / 4.0))
        self.assertLess(abs(late[at] - exact), 0.04)
        self.assertAlmostEqual(late[-1], 1.0 - 8.0 / np.pi**2 * np.exp(-3.0), delta=0.003)

    def test_a_delay_of_whole_rows_gives_earlier_rows(self):
        signal = np.sin(np.arange(50.0))
        np.testing.assert_allclose(laws.late_by_a_time(rows(signal), 2.0)[2:], signal[:-2] - signal[2:], atol=1e-12)

    def test_friction_is_in_full_against_each_motion(self):
        signal = np.r_[np.linspace(0, 1, 200), np.linspace(1, 0, 200)]
        added = laws.friction_of_dahl(rows(signal), 0.1)
        self.assertAlmostEqual(added[199], -0.1, delta=1e-6)
        self.assertAlmostEqual(added[-1], 0.1, delta=1e-6)

    def test_what_fades_leaves_nothing_of_a_signal_that_is_held(self):
        held = np.r_[np.zeros(10), np.ones(4000)]
        self.assertLess(abs(laws.relaxes(rows(held), 100.0)[-1]), 1e-9)

    def test_what_saturates_never_turns_back(self):
        signal = np.linspace(0.0, 1.0, 500)
        reading = signal + laws.characteristic_saturates(rows(signal), 20.0)
        self.assertTrue((np.diff(reading) > 0).all())
        self.assertTrue((reading[signal < 0.5] == signal[signal < 0.5]).all())

    def test_nothing_is_added_before_a_jump(self):
        for law in (laws.zero_jumps, laws.gain_jumps):
            added = law(rows(np.ones(101)), 2.0)
            self.assertEqual((added[:51] != 0).sum(), 0)
            np.testing.assert_allclose(added[51:], 2.0)

    def test_every_name_that_is_right_is_in_the_library(self):
        listed = EFFECTS.read_text(encoding="utf-8")
        for kind in laws.KINDS:
            for name in kind.right:
                self.assertIn(f"| [`{name}`](#{name}) |", listed)


if __name__ == "__main__":
    unittest.main()
