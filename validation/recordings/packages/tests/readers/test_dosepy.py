"""Files of the package dosepy, read from small ones that are made here."""

import unittest

import numpy as np
from tests.made import READS, told, written

if READS:
    from readers import dosepy


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_film_is_thinned_in_both_directions_and_knows_its_place(self):
        dose = np.arange(12.0).reshape(3, 4)
        read = told(dosepy.film(written(dose + 100), written(dose), millimetres=2, every=2))
        self.assertEqual(read, {"place_mm": [0, 0, 4, 4], "planned_gy": [0, 2, 8, 10], "film_gy": [100, 102, 108, 110]})


if __name__ == "__main__":
    unittest.main()
