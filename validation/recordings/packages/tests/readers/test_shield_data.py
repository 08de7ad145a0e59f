"""Files of the package shield_data, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import shield_data


HEAD = ",".join(["RealTimestamp", *(["WGM701_Voltage (V)", "CVM211_Voltage (V)", "Baratron626D_1KT_Voltage (V)", "Baratron626D_1T_Voltage (V)"])])
RIG = (HEAD + "\n" + "\n".join(f"2025-10-06 10:00:{k:02d}.000,{k},{2 * k},{3 * k},{k / 10}" for k in range(8)) + "\n").encode()


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_gauges_are_means_of_rows_behind_a_second(self):
        read = shield_data.permeation(RIG, 2, "wire_v", "upper_v", begin=1)
        self.assertEqual(told(read), {"time_s": [0, 2, 4], "wire_v": [2.5, 4.5, 6.5], "upper_v": [7.5, 13.5, 19.5]})

    def test_gauges_are_told_while_the_lower_one_is_between_two_volts(self):
        self.assertEqual(told(shield_data.permeation(RIG, 1, "lower_v", lower=(0.2, 0.5))), {"time_s": [0, 1], "lower_v": [0.3, 0.4]})


if __name__ == "__main__":
    unittest.main()
