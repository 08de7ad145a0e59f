"""Files of the package datalabicb, read from small ones that are made here."""

import gzip
import json
import unittest

from tests.made import READS

if READS:
    from readers import datalabicb

TAKEN = gzip.compress(json.dumps([{}, {"data": [{"pads / hPa": 1, "maads ": 0.1, "pdes / hPa": 3, "mades": 0.4}, {"pads / hPa": 2, "maads ": 0.2, "pdes / hPa": 0, "mades": 0}]}]).encode())


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_branches_follow_one_another_without_the_zeros_that_fill_them_up(self):
        x, y = datalabicb.sorption(TAKEN, 1, ("pads / hPa", "maads"), ("pdes / hPa", "mades"))
        self.assertEqual((x.tolist(), y.tolist()), ([1, 2, 3], [0.1, 0.2, 0.4]))


if __name__ == "__main__":
    unittest.main()
