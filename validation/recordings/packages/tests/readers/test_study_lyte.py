"""Files of the package study-lyte, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import study_lyte as read

HEAD = "RECORDED = 2022-03-02--10:35:49\nSAMPLE RATE = 16000\n"
PUSH = (HEAD + "time,Sensor1,depth\n0,10,-1\n0.001,11,-2\n0.002,12,-3\n0.003,13,-4\n0.013,14,-5\n").encode()


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_rows_begin_below_the_lines_about_the_pole(self):
        self.assertEqual(list(read.table(PUSH).columns), ["time", "Sensor1", "depth"])
        self.assertEqual(len(read.table(PUSH[len(HEAD) :])), 5)

    def test_of_a_push_one_row_in_two_is_kept_before_rows_come_slowly(self):
        self.assertEqual(told(read.push(PUSH, 2)), {"time": [0, 0.002], "Sensor1": [10, 12], "depth": [-1, -3]})

    def test_an_acceleration_adds_up_twice_to_a_depth(self):
        rows = "".join(f"{k},{-1.0 if k < 2 else -0.5},{100 - k}\n" for k in range(200))
        depths = told(read.depths(("time,Y-Axis,filtereddepth\n" + rows).encode()))
        self.assertEqual(depths["push_cm"][:3], [0, 0, round(-981 * 0.5 / 4, 6)])
        self.assertEqual(depths["barometer_cm"][:2], [100, 99])


if __name__ == "__main__":
    unittest.main()
