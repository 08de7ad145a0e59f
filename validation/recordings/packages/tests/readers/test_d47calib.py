"""Files of the package d47calib, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import d47calib


MASSES = b"Sample,Date,Time,Session,d46\nA,2019-04-23,10:00,1,5\nB,2019-04-22,10:00,1,4\nC,2019-04-22,11:00,2,3\n"
SESSIONS = b"UID,Session,d46\n1,B,5\n2,A,6\n3,B,7\n4,A,\n"


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_session_is_read_in_the_order_of_its_clock(self):
        self.assertEqual(told(d47calib.one_session(MASSES, 1, mass="d46")), {"time_s": [0, 86400], "mass": [4, 5]})

    def test_sessions_are_runs_as_they_come(self):
        self.assertEqual(told(d47calib.by_session(SESSIONS, mass="d46")), {"run": [1, 1, 2], "mass": [5, 7, 6]})


if __name__ == "__main__":
    unittest.main()
