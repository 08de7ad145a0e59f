"""Files of the package sktime, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import sktime


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_half_hours_of_a_country(self):
        content = b"datetime_gmt,solar_gen\n2021-05-01 00:00:00+00:00,0\n2021-05-01 00:30:00+00:00,0.25\n"
        self.assertEqual(told(sktime.solar_half_hours(content)), {"time_s": [0, 1800], "solar": [0, 0.25]})


if __name__ == "__main__":
    unittest.main()
