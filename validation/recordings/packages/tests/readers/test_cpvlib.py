"""Files of the package cpvlib, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import cpvlib

STATION = "yyyy/mm/dd hh:mm\tBn\tElev.Sol\n2020/03/04 07:00\t1\tNaN\n2020/03/04 07:01\t2\t5\n2020/03/04 07:02\t3\t6\n2020/03/04 07:03\t4\t7\n"
MODULE = """Date Time,DNI (W/m2),T_Amb (\xb0C),Wind Speed (m/s),Wind Dir. (m/s),T_Backplane (\xb0C)
01-Jun-2019 06:00:00,   500.0, 20.0, 1.0, 90.0, 30.0
02-Jun-2019 06:00:00,    50.0, 20.0, 1.0, 90.0, 30.0
02-Jun-2019 06:01:01,   500.0, 21.0, 2.0, 90.0, 31.0
02-Jun-2019 06:02:02,   500.0, 22.0, 3.0, 90.0, 32.0
"""


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_station_is_read_where_the_sun_is_high_enough(self):
        self.assertEqual(told(cpvlib.sunny_station(STATION.encode(), 5, sun="Bn")), {"time_s": [0, 60], "sun": [3, 4]})
        self.assertEqual(told(cpvlib.sunny_station(STATION.encode(), sun="Bn")), {"time_s": [0, 60, 120, 180], "sun": [1, 2, 3, 4]})

    def test_a_module_is_read_between_two_days_in_the_sun(self):
        read = cpvlib.solar_module(MODULE.encode("latin1"), "2019-06-02", "2019-06-05", 100)
        self.assertEqual(told(read), {"time_s": [0, 61], "air_degc": [21, 22], "wind_m_s": [2, 3], "back_degc": [31, 32]})


if __name__ == "__main__":
    unittest.main()
