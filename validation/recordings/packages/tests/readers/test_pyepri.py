"""Files of the package pyepri, read from small ones that are made here."""

import pickle
import unittest

import numpy as np
from tests.made import READS

if READS:
    from readers import pyepri


def pickled_array(values):
    """A spectrum as pyepri keeps it."""
    return pickle.dumps({"B": np.arange(len(values)), "DAT": np.array(values, np.float32), "PARAM": None})


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_spectra_of_radicals_are_thinned(self):
        read = pyepri.radicals(pickled_array([1, 2, 3]), pickled_array([4, 5, 6]), every=2)
        self.assertEqual([values.tolist() for values in read], [[1, 3], [4, 6]])


if __name__ == "__main__":
    unittest.main()
