"""Files of the package spectrapepper, read from small ones that are made here."""

import unittest

import numpy as np
from tests.made import READS, left_by, told

if READS:
    from readers import spectrapepper


FILMS = b"1 2 3\n10 20 30\n11 21 31\n12 22 32\n"


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_films_are_counted_behind_the_line_of_their_shift(self):
        self.assertEqual(told(spectrapepper.films(FILMS, 0, 2)), {"shift_1_cm": [1, 2, 3], "first": [10, 20, 30], "second": [12, 22, 32]})


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Models(unittest.TestCase):
    def test_a_background_by_the_place_is_found(self):
        place = np.linspace(50, 900, 100)
        first = 2 + np.exp(-(((place - 200) / 20) ** 2))
        second = 1.5 * first + place / 300
        left = left_by(second, spectrapepper.film_models({"second": second, "first": first, "shift_1_cm": place})[1])
        self.assertLess(left["place"], 1e-9)
        self.assertGreater(left["line"], 0.1)


if __name__ == "__main__":
    unittest.main()
