"""Files of the package citylearn, read from small ones that are made here."""

import unittest

import numpy as np
from tests.made import READS, told

if READS:
    from readers import citylearn


def house(power):
    """Hours of a house with solar cells."""
    return ("Hour,Solar Generation [W/kW]\n" + "".join(f"{k % 24 + 1},{value}\n" for k, value in enumerate(power))).encode()


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_roofs_are_read_while_both_have_the_sun(self):
        first, second = [0] * 24 + [0, 30, 40, 50, 5, 60] + [0] * 18 + [70], [0] * 24 + [9, 31, 41, 1, 51, 61] + [0] * 18 + [71]
        self.assertEqual(told(citylearn.roofs(house(first), house(second), 1, 2, 20)), {"time_s": [0, 3600, 14400], "first_w_kw": [30, 40, 60], "second_w_kw": [31, 41, 61]})


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Models(unittest.TestCase):
    def test_a_slope_that_changes_is_found_where_it_does(self):
        t, rng = np.arange(200.0), np.random.default_rng(1)
        x = rng.uniform(1, 2, 200)
        y = x * np.where(t >= 120, 1.1, 1.0)
        seen = np.ones(200, bool)
        left = {name: np.std(y - model(seen)) for name, model in citylearn.changed_at_best(y, x, t, np.arange(0.05, 0.96, 0.01)).items()}
        self.assertLess(left["slope that changes"], 1e-9)
        self.assertGreater(left["step"], 0.01)


if __name__ == "__main__":
    unittest.main()
