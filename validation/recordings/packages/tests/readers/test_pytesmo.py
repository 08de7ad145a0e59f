"""Files of the package pytesmo, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import pytesmo


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_probe_is_asked_as_a_satellite_passes(self):
        probe = b"date_time,soil_moisture,soil_moisture_flag\n2017-01-01 00:00:00,0.5,G\n2017-01-01 01:00:00,0.9,D04\n2017-01-01 02:00:00,0.4,G\n"
        satellite = b",sm,snow\n2016-12-31 20:00:00,30,\n2017-01-01 00:10:00,35,\n2017-01-01 01:00:00,36,\n2017-01-01 01:40:00,37,\n2017-01-01 02:00:00,,\n"
        self.assertEqual(told(pytesmo.wet_soil(probe, satellite, 35)), {"time_s": [0, 5400], "satellite_percent": [35, 37], "probe_m3_m3": [0.5, 0.4]})


if __name__ == "__main__":
    unittest.main()
