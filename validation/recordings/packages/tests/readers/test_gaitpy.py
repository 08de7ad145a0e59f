"""Files of the package gaitpy, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import gaitpy


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_wrist_sensor_begins_after_a_hundred_lines(self):
        rows = "\n".join(f"2019-08-06 10:25:50:{k:03},0,0,0,0,0,{30 + k / 100}" for k in (0, 20, 40, 60))
        self.assertEqual(told(gaitpy.wrist_sensor(("x\n" * 100 + rows + "\n").encode(), 2)), {"time_s": [0, 0.04], "sensor_degc": [30, 30.4]})


if __name__ == "__main__":
    unittest.main()
