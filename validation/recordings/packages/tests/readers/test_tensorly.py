"""Files of the package tensorly, read from small ones that are made here."""

import io
import unittest

import numpy as np
from tests.made import READS

if READS:
    from readers import tensorly


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_glow_is_of_one_colour_under_others(self):
        out = io.BytesIO()
        np.save(out, np.arange(2 * 2 * 2 * 3).reshape(2, 2, 2, 3))
        first, second = tensorly.glow(out.getvalue(), [1], 0, 0, 1)
        self.assertEqual([first.tolist(), second.tolist()], [[[12, 13, 14]], [[15, 16, 17]]])


if __name__ == "__main__":
    unittest.main()
