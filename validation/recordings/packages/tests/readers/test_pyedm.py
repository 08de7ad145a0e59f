"""Files of the package pyEDM, read from small ones that are made here."""

import unittest

from durations import DAY, YEAR

from tests.made import READS, told

if READS:
    from readers import pyedm as read


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_piers_have_a_row_a_year(self):
        read_piers = told(read.piers(b"year,anchovy,sardine,sio_sst,np_sst\n1929,0,1,-0.3,-0.2\n1930,0,1,0.5,0.4\n"))
        self.assertEqual(read_piers, {"time_s": [0, YEAR], "newport": [-0.2, 0.4], "scripps": [-0.3, 0.5]})

    def test_gates_have_seconds_since_the_first_row(self):
        self.assertEqual(told(read.gates(b"Date,S12.C.D.S333\n1979-12-31,52.9\n1980-01-07,391.1\n")), {"time_s": [0, 7 * DAY], "flow": [52.9, 391.1]})

    def test_a_fly_has_one_part_of_its_brain(self):
        read_fly = told(read.fly(b"index,TS1,TS5,Left_Right,FWD\n1,9,0.5,-1,2\n11,9,0.6,-2,3\n", "TS5"))
        self.assertEqual(read_fly, {"time_s": [0, 10], "walk": [2, 3], "turn": [-1, -2], "glow": [0.5, 0.6]})


if __name__ == "__main__":
    unittest.main()
