"""Files of the package mobgap, read from small ones that are made here."""

import io
import unittest

import numpy as np
from tests.made import READS, told

if READS:
    from readers import mobgap
    from scipy.io import savemat


def person(*trials):
    """A file of a person whose trials are told as bouts of cameras and of sensors."""
    out = io.BytesIO()
    seen = {f"Trial{k}": {"Standards": {way: {"MicroWB": bout} for way, bout in trial.items()}} for k, trial in enumerate(trials, 1)}
    savemat(out, {"data": {"TimeMeasure1": {"Test5": seen}}})
    return out.getvalue()


def bout(contacts, lengths):
    """A bout of strides."""
    return {"Stride_InitialContacts": np.array(contacts, float), "Stride_Length": np.array(lengths, float)}


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_strides_are_paired_where_they_begin_and_end_together(self):
        cameras, worn = bout([[1, 2], [2, 3.5], [4, 5]], [1.1, np.nan, 1.3]), bout([[105, 205], [200, 350], [430, 500]], [1.2, 1.4, 1.5])
        read = mobgap.strides(person({"Stereophoto": cameras, "INDIP": worn}, {"INDIP": worn}, {"Stereophoto": bout([], []), "INDIP": worn}), apart=0.12)
        self.assertEqual(told(read), {"cameras_m": [1.1], "worn_m": [1.2]})


if __name__ == "__main__":
    unittest.main()
