"""Files of the package py-wave-runup, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import py_wave_runup

WAVES = "\ufeffDataset,Beach,Case,Lab/field,Hs [m],Tp [s],tanB [-],D50 [m],Roughness [m],R2% (-SWL) [m]\nA,ONE,1,F,0.5,6,0.1,,,2\nA,TWO,1,F,0.6,7,0.2,,,3\n".encode()


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_one_beach_of_a_table_with_a_mark_of_its_order(self):
        self.assertEqual(told(py_wave_runup.runup(WAVES, "TWO")), {"height_m": [0.6], "slope": [0.2], "period_s": [7], "runup_m": [3]})


if __name__ == "__main__":
    unittest.main()
