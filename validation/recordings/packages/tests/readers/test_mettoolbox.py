"""Files of the package mettoolbox, read from small ones that are made here."""

import gzip
import unittest

from tests.made import READS, told

if READS:
    from readers import mettoolbox


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_thermometers_are_told_in_celsius_between_two_dates(self):
        content = "\ufeffDate,A,B\n1/1/1950,0,0\n1/2/1950,32,50\n1/3/1950,0,0\n1/4/1950,212,14\n1/5/1950,0,0\n".encode()
        read = mettoolbox.thermometers(content, "A", "B", "1950-01-02", "1950-01-04", every=2)
        self.assertEqual(told(read), {"time_s": [0, 172800], "there_degc": [0, 100], "here_degc": [10, -10]})

    def test_hours_without_a_number_are_left_out(self):
        content = gzip.compress(b",temp,precip,hum,glob,wind\n2014-05-01 00:00:00,5,0,90,0,1\n2014-05-01 01:00:00,,0,91,0,1\n2014-05-01 02:00:00,7,0,80,3,1\n2014-06-01 00:00:00,9,0,70,0,1\n")
        read = mettoolbox.weather_hours(content, "2014-05", "2014-05")
        self.assertEqual(told(read), {"time_s": [0, 7200], "air_degc": [5, 7], "sun_w_m2": [0, 3], "humidity_percent": [90, 80]})


if __name__ == "__main__":
    unittest.main()
