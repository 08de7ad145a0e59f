"""Files of the package hysom, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import hysom

RIVER = b"datetime,Qcms,turb\n2020-01-01 00:00:00+00:00,1,10\n2020-01-01 00:15:00+00:00,2,20\n2020-01-01 00:30:00+00:00,3,\n2020-01-01 00:45:00+00:00,4,40\n2020-01-01 01:00:00+00:00,5,50\n"
EVENTS = b"start,end\n2019-01-01 00:00:00+0000,2019-01-02 00:00:00+0000\n2020-01-01 00:10:00+0000,2020-01-01 00:50:00+0000\n"


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_storm_is_read_between_its_begin_and_its_end(self):
        self.assertEqual(told(hysom.storm(RIVER, EVENTS, 1)), {"time_s": [0, 1800], "flow_m3_s": [2, 4], "turbidity_fnu": [20, 40]})


if __name__ == "__main__":
    unittest.main()
