"""Files of the package UConnRCMPy, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import uconnrcmpy

ONE = b"0.000\t1\n0.001\t2\n0.002\t3\n0.003\t4\n0.004\t5\n"
OTHER = b"0.000\t10\n0.001\t20\n0.002\t30\n0.003\t40\n0.004\t50\n"


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_two_shots_are_read_over_the_same_stretch(self):
        read = uconnrcmpy.two_shots(ONE, OTHER, first=1, last=5, every=2)
        self.assertEqual(told(read), {"time_s": [0, 0.002], "first_v": [2, 4], "second_v": [20, 40]})

    def test_slow_shots_are_means_after_some_second(self):
        read = uconnrcmpy.slow_shots(ONE, OTHER, begin=0.001, rows=2)
        self.assertEqual(told(read), {"time_s": [0], "first_v": [3.5], "second_v": [35]})
        self.assertEqual(told(uconnrcmpy.slow_shots(ONE, begin=0, rows=2)), {"time_s": [0, 0.002], "first_v": [1.5, 3.5]})


if __name__ == "__main__":
    unittest.main()
