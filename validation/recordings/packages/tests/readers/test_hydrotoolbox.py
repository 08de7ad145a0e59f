"""Files of the package hydrotoolbox, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import hydrotoolbox


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_spring_is_read_by_its_means_and_without_days_that_lack_one(self):
        head = "Datetime,USGS_1_2_00010_00001:degC,USGS_1_3_00010_00003:degC,USGS_1_4_00065_00003:ft"
        read = hydrotoolbox.spring(f"{head}\n2020-01-01,9,20,1\n2020-01-02,9,,2\n2020-01-03,9,22,10\n".encode(), "water_degc", "stage_m")
        self.assertEqual(told(read), {"water_degc": [20, 22], "stage_m": [0.3048, 3.048], "time_s": [0, 172800]})


if __name__ == "__main__":
    unittest.main()
