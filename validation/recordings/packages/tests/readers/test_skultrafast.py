"""Files of the package skultrafast, read from small ones that are made here."""

import io
import unittest

import numpy as np
from tests.made import READS

if READS:
    from readers import skultrafast


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_pixels_under_a_grating_are_rows(self):
        out = io.BytesIO()
        np.savez(out, probe=np.arange(6.0).reshape(2, 3), wl=np.zeros((2, 3)))
        self.assertEqual(skultrafast.grating(out.getvalue(), 2, 0).tolist(), [[2, 5], [0, 3]])


if __name__ == "__main__":
    unittest.main()
