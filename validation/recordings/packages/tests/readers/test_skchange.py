"""Files of the package skchange, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers.skchange import fan


FANS = b",time,vibration,unit_id\n0,2023-03-18 06:10:00+00:00,0.4,0\n1,2023-03-18 06:20:00+00:00,0.08,0\n2,2023-03-18 06:10:00+00:00,0.05,1\n3,2023-03-18 06:40:00+00:00,0.09,0\n"


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_one_fan_is_read(self):
        self.assertEqual(told(fan(FANS, 0)), {"time_s": [0, 600, 1800], "shaking": [0.4, 0.08, 0.09]})

    def test_rows_between_two_values_are_kept(self):
        self.assertEqual(told(fan(FANS, 0, 0.03, 0.2)), {"time_s": [0, 1200], "shaking": [0.08, 0.09]})


if __name__ == "__main__":
    unittest.main()
