"""Files of the package openap, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import openap

FLIGHT = b"ts,fan,fuel\n1,10,0.1\n2,20,\n3,30,0.3\n4,40,0.4\n5,50,0.5\n6,60,0.6\n"
ENGINES = b"uid,type,bpr,max_thrust,ff_to\na,TF,2,15600,0.2\nb,MTF,3,20000,0.3\nc,TF,,30000,0.4\nd,TF,5,40000,0.5\n"


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_flight_is_read_where_all_columns_have_numbers(self):
        read = openap.flight(FLIGHT, 1, 2, {"kg_h": 3600}, fan_percent="fan", kg_h="fuel")
        self.assertEqual(told(read), {"time_s": [0, 2], "fan_percent": [30, 50], "kg_h": [1080, 1800]})

    def test_engines_that_mix_their_streams_are_left_out(self):
        self.assertEqual(told(openap.engines(ENGINES)), {"bypass": [2, 5], "thrust_kn": [15.6, 40], "fuel_kg_s": [0.2, 0.5]})


if __name__ == "__main__":
    unittest.main()
