"""Files of the package process-nitta, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import process_nitta

STRIP = '"name","N","mm"\n" 1 - 1","1.99","2.53","10.0",\n"sec","N","mm",\n"0.00",-.5,0,\n"0.05",1,.1,\n"0.10",2,.2,\n"0.15",3,.3,\n"0.20",9,.4,\n"0.25",0,.5,\n'.encode("cp932")


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_strip_is_read_until_its_greatest_force(self):
        self.assertEqual(told(process_nitta.pulled_strip(STRIP, 2)), {"time_s": [0, 0.1], "stroke_mm": [0, 0.2], "force_n": [-0.5, 2]})


if __name__ == "__main__":
    unittest.main()
