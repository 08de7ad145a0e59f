"""Files of the package ISLP, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import islp

CARS = b'mpg   weight   year  name\n18.0   3504.   70   "a b"\n26.0   2130.   71   "c"\n'
RIDERS = b'"day","hr","casual","registered"\n1,"22",1,5\n1,"23",2,6\n2,"1",3,7\n2,"2",4,8\n'


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_cars_have_names_of_several_words(self):
        self.assertEqual(told(islp.cars(CARS)), {"weight_lb": [3504, 2130], "year": [1970, 1971], "miles_gallon": [18, 26]})

    def test_riders_have_a_clock_by_day_and_hour(self):
        self.assertEqual(told(islp.riders(RIDERS, 1, 3)), {"time_s": [0, 7200, 10800], "casual": [2, 3, 4], "registered": [6, 7, 8]})


if __name__ == "__main__":
    unittest.main()
