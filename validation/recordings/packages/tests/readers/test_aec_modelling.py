"""Files of the package aec-modelling, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import aec_modelling

STACK = b"j,T,V,P,w,time\n20,306.15,2.5,1,,2023-06-22 14:49:00\n10,305.15,2.25,1,,2023-06-22 14:48:00\n"


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_stack_is_read_in_the_order_of_its_clock(self):
        self.assertEqual(told(aec_modelling.stack(STACK)), {"time_s": [0, 60], "current_ma_cm2": [10, 20], "warmth_degc": [32, 33], "volts": [2.25, 2.5]})


if __name__ == "__main__":
    unittest.main()
