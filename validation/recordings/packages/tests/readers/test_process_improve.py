"""Files of the package process-improve, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import process_improve

DRYER = b"""batch_id,AgitatorPower,JacketTemperatureSP,JacketTemperature,DryerTemp,ClockTime
1,9,60,84,70,0
1,9,60,84,75,1
1,9,60,84,80,2
1,9,-5,50,81,3
1,9,0,20,79,4
2,9,0,16,80,0
3,9,0,16,80,0
"""


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_dryer_is_read_from_some_rows_before_its_jacket_is_cooled(self):
        read = process_improve.cooled_batches(DRYER, 1, 2, before=1)
        self.assertEqual(told(read), {"run": [1, 1, 1, 2], "time_s": [120, 180, 240, 0], "jacket_degc": [84, 50, 20, 16], "product_degc": [80, 81, 79, 80]})


if __name__ == "__main__":
    unittest.main()
