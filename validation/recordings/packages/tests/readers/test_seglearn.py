"""Files of the package seglearn, read from small ones that are made here."""

import io
import math
import unittest

from tests.made import READS, told

if READS:
    import numpy as np
    from readers.seglearn import turned


def watches(*exercises):
    """What watches told, as the bytes of a file."""
    out = io.BytesIO()
    np.save(out, np.array({"X": [[list(row) for row in one] for one in exercises]}, dtype=object), allow_pickle=True)
    return out.getvalue()


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_turn_is_told_by_the_way_down_and_by_its_rate(self):
        still, quarter = [0, 0, 1, 0, 2, 0], [1, 0, 0, 0, 2, 0]
        read = told(turned(watches([still], [still, quarter]), 1, 1))
        self.assertEqual(read["time_s"], [0, 0.02])
        self.assertEqual(read["tilt_rad"], [0, round(math.pi / 2, 6)])
        self.assertEqual(read["turned_rad"], [0, 0.04])


if __name__ == "__main__":
    unittest.main()
