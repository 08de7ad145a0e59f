"""Files of the package galileoqc, read from small ones that are made here."""

import unittest

import numpy as np
from tests.made import READS, told

if READS:
    from readers import galileoqc

SURVEY = b"""/
/   LINE FLIGHT FTIME MGA-X RALT FA
 Line 7.01
 7.01 3 100.0 0 10 0
 7.01 3 100.5 10 20 1
 7.01 3 101.0 20 30 2
 Line 7.02
 7.02 3 200.0 25 35 9
 7.02 3 200.5 15 25 2.5
 7.02 3 201.0 5 15 1.5
"""


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_lines_of_a_survey_are_runs(self):
        self.assertEqual(told(galileoqc.survey(SURVEY, radar="RALT")), {"run": [1, 1, 1, 2, 2, 2], "time_s": [0, 0.5, 1, 100, 100.5, 101], "radar": [10, 20, 30, 35, 25, 15]})

    def test_a_line_that_was_flown_again_is_put_beside_the_first_at_the_same_places(self):
        self.assertEqual(told(galileoqc.flown_again(SURVEY, 1, "FA")), {"run": [1, 1], "first_mgal": [0.5, 1.5], "again_mgal": [1.5, 2.5]})


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Models(unittest.TestCase):
    def test_a_mean_over_rows_stays_inside_of_its_run(self):
        self.assertEqual(galileoqc.means_along_runs(np.array([1.0, 2, 6, 10, 20]), np.array([1, 1, 1, 2, 2]), 3).tolist(), [1.5, 3, 4, 15, 15])


if __name__ == "__main__":
    unittest.main()
