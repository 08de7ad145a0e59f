"""Files of the package bibmon, read from small ones that are made here."""

import unittest

import numpy as np
from tests.made import READS, told

if READS:
    from readers import bibmon

PLANT = b",tag0,tag1,tag2\n2017-12-24 00:00:00,1,2,3\n2017-12-24 00:05:00,4,5,Inp OutRange\n"


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_words_in_a_plants_table_are_no_numbers(self):
        read = bibmon.plant_tags(PLANT, first="tag0", second="tag2")
        self.assertEqual(told({name: read[name] for name in ("time_s", "first")}), {"time_s": [0, 300], "first": [1, 4]})
        self.assertTrue(np.isnan(read["second"].iloc[1]))


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Models(unittest.TestCase):
    def test_a_day_is_found_beside_a_zero_that_changes(self):
        t, rng = np.arange(0, 6 * 86400, 1800.0), np.random.default_rng(2)
        x = rng.normal(size=len(t))
        y = x + np.sin(2 * np.pi * t / 86400) + (t > 4 * 86400)
        seen = np.ones(len(t), bool)
        left = {name: np.std(y - model(seen)) for name, model in bibmon.days_and_changes(y, x, t).items()}
        self.assertLess(left["day, and step"], 1e-9)
        self.assertGreater(left["day"], 0.1)


if __name__ == "__main__":
    unittest.main()
