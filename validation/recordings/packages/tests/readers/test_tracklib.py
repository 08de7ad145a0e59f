"""Files of the package tracklib, read from small ones that are made here."""

import unittest

import numpy as np
from tests.made import READS, told

if READS:
    from readers import tracklib

WATCH = """<trkpt lat="48.5" lon="2.5">
  <ele>51.8</ele>
  <time>2021-07-01T00:00:10Z</time></trkpt><trkpt lat="48.6" lon="2.4"><ele>5</ele><time>2021-07-01T00:00:11.5Z</time></trkpt>
"""


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_points_of_a_watch(self):
        t, north, east = tracklib.watch(WATCH.encode())
        self.assertEqual((t.tolist(), north.tolist(), east.tolist()), ([10, 11.5], [48.5, 48.6], [2.5, 2.4]))

    def test_a_receiver_tells_places_from_the_middle_of_the_earth(self):
        lines = "% heading\n2021/07/01 00:00:01.000 6378137.0 0.0 0.0 5\n2021/07/01 00:00:02.000 0.0 4517590.8789 4487348.4088 5\n"
        t, north, east = tracklib.receiver(lines.encode())
        self.assertEqual((t.tolist(), north.round(6).tolist(), east.tolist()), ([1, 2], [0, 45], [0, 90]))

    def test_two_tracks_are_put_together_in_metres(self):
        first = np.arange(0.0, 40, 2), np.arange(0.0, 40, 2) / tracklib.DEGREE, np.zeros(20)
        second = np.arange(0.0, 60, 3) + 10, np.arange(0.0, 60, 3) / tracklib.DEGREE, np.zeros(20)
        read = tracklib.two_tracks(first, second, "north", 2, late=10)
        self.assertEqual(told(read), {"time_s": [0, 6, 12, 18, 24], "first_m": [-13.5, -7.5, -1.5, 4.5, 10.5], "second_m": [-13.5, -7.5, -1.5, 4.5, 10.5]})


if __name__ == "__main__":
    unittest.main()
