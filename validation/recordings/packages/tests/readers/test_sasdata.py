"""Files of the package sasdata, read from small ones that are made here."""

import unittest

import numpy as np
from tests.made import READS, told, written

if READS:
    from readers import sasdata


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_polarised_neutrons_know_their_direction_and_how_far_they_were_turned(self):
        table = np.array([[0.03, 0.0, 5, 1], [0.0, 0.04, 6, 1], [0.3, 0.4, 7, 1], [0.03, 0.04, -1, 1]])
        head = {"delimiter": "\t", "header": "ASCII data\n", "comments": ""}
        read = sasdata.polarised_neutrons(written(table, **head), written(table * [1, 1, 2, 1], **head), widest=0.1, every=1)
        self.assertEqual(told(read), {"across": [0, 1], "way_1_nm": [0.3, 0.4], "against": [10, 12], "along": [5, 6]})


if __name__ == "__main__":
    unittest.main()
