"""Files of the package pyoxynet, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import pyoxynet

EXERCISE = b",time,VO2_I,HR_I\n0,5,900,80\n1,6,950,81\n2,7,1000,82\n3,8,1050,83\n"


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_an_exercise_test(self):
        self.assertEqual(told(pyoxynet.exercise(EXERCISE, 3, oxygen="VO2_I", heart="HR_I")), {"time_s": [0, 3], "oxygen": [900, 1050], "heart": [80, 83]})


if __name__ == "__main__":
    unittest.main()
