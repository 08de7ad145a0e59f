"""Readers of the twenty-eighth set, on small tables that are made here."""

import bz2
import importlib.util
import unittest

import numpy as np
from tests.made import left_by, told

READS = all(importlib.util.find_spec(name) for name in ("scipy", "pandas"))
if READS:
    import pointers


ONE = b"0.000\t1\n0.001\t2\n0.002\t3\n0.003\t4\n0.004\t5\n"
OTHER = b"0.000\t10\n0.001\t20\n0.002\t30\n0.003\t40\n0.004\t50\n"
STRIP = '"name","N","mm"\n" 1 - 1","1.99","2.53","10.0",\n"sec","N","mm",\n"0.00",-.5,0,\n"0.05",1,.1,\n"0.10",2,.2,\n"0.15",3,.3,\n"0.20",9,.4,\n"0.25",0,.5,\n'.encode("cp932")
BUOY = b"time (YYYY-MM-DD-HH); height (m); period (s)\n1996-01-01-00; 0.5; 4\n1996-01-01-01; 0.6; 5\n1996-01-01-04; 0.7; 6\n"
BOOK = bz2.compress(b'"Field","Lab","Batch"\n18,20.2,"1"\n38,56,"2"\n')
BANK = b'"zinc","copper","om","soil"\n1,2,3,"1"\n4,5,,"1"\n6,7,8,"2"\n'
TOWN = b"id it kdown Tair\n1 0 0 5\n1 1 10 6\n1 2 20 7\n1 3 30 8\n"
CARS = b'mpg   weight   year  name\n18.0   3504.   70   "a b"\n26.0   2130.   71   "c"\n'
RIDERS = b'"day","hr","casual","registered"\n1,"22",1,5\n1,"23",2,6\n2,"1",3,7\n2,"2",4,8\n'


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_two_shots_are_read_over_the_same_stretch(self):
        read = pointers.shots(ONE, OTHER, first=1, last=5, every=2)
        self.assertEqual(told(read), {"time_s": [0, 0.002], "first_v": [2, 4], "second_v": [20, 40]})

    def test_slow_shots_are_means_after_some_second(self):
        read = pointers.slow_shots(ONE, OTHER, begin=0.001, rows=2)
        self.assertEqual(told(read), {"time_s": [0], "first_v": [3.5], "second_v": [35]})
        self.assertEqual(told(pointers.slow_shots(ONE, begin=0, rows=2)), {"time_s": [0, 0.002], "first_v": [1.5, 3.5]})

    def test_a_strip_is_read_until_its_greatest_force(self):
        self.assertEqual(told(pointers.stretched(STRIP, 2)), {"time_s": [0, 0.1], "stroke_mm": [0, 0.2], "force_n": [-0.5, 2]})

    def test_hours_that_a_buoy_leaves_out_stay_on_the_clock(self):
        self.assertEqual(told(pointers.sea(BUOY, 2)), {"time_s": [0, 14400], "height_m": [0.5, 0.7], "period_s": [4, 6]})

    def test_a_packed_table(self):
        self.assertEqual(told(pointers.of_book(BOOK, run="Batch", lab="Lab")), {"run": [1, 2], "lab": [20.2, 56]})

    def test_soil_with_a_gap_is_left_out(self):
        self.assertEqual(told(pointers.bank(BANK, zinc_ppm="zinc", copper_ppm="copper")), {"zinc_ppm": [1, 6], "copper_ppm": [2, 7]})

    def test_hours_of_a_town(self):
        self.assertEqual(told(pointers.town(TOWN, 1, 2, sun="kdown", air="Tair")), {"time_s": [0, 3600], "sun": [10, 20], "air": [6, 7]})

    def test_cars_have_names_of_several_words(self):
        self.assertEqual(told(pointers.cars(CARS)), {"weight_lb": [3504, 2130], "year": [1970, 1971], "miles_gallon": [18, 26]})

    def test_riders_have_a_clock_by_day_and_hour(self):
        self.assertEqual(told(pointers.riders(RIDERS, 1, 3)), {"time_s": [0, 7200, 10800], "casual": [2, 3, 4], "registered": [6, 7, 8]})


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Models(unittest.TestCase):
    def test_three_waves_of_a_day_are_found_beside_a_bend(self):
        t, rng = np.arange(0, 8 * 86400, 3600.0), np.random.default_rng(1)
        x = rng.normal(size=len(t))
        left = left_by(2 * x + x**2 + np.sin(6 * np.pi * t / 86400), pointers.by_day(2 * x + x**2 + np.sin(6 * np.pi * t / 86400), x, t))
        self.assertLess(left["day, and square"], 1e-9)
        self.assertGreater(left["day"], 0.5)
        self.assertGreater(left["two waves a day"], left["day"])

    def test_two_drivers_are_found_beside_one_another(self):
        x, a, b = np.random.default_rng(2).normal(size=(3, 200))
        left = left_by(x + 2 * a - b, pointers.two_drivers(x + 2 * a - b, x, a=a, b=b))
        self.assertLess(left["a and b"], 1e-9)


if __name__ == "__main__":
    unittest.main()
