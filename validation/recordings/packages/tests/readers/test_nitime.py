"""Files of the package nitime, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import nitime


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_any_kind_of_event_was_shown(self):
        self.assertEqual(told(nitime.shown_events(b"bold,events\n0.5,0\n-0.5,4\n", 2)), {"time_s": [0, 2], "shown": [0, 1], "signal": [0.5, -0.5]})


if __name__ == "__main__":
    unittest.main()
