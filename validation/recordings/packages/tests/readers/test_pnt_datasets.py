"""Files of the package pnt-datasets, read from small ones that are made here."""

import importlib.util
import io
import unittest

from tests.made import READS, told

if READS:
    import pandas as pd
    from readers import pnt_datasets as read


def parquet(**columns):
    """A table as the bytes of a file."""
    out = io.BytesIO()
    pd.DataFrame(columns).to_parquet(out)
    return out.getvalue()


def session(times, stations, ns, dbm):
    """What stations measured, a row each time and station."""
    return parquet(**{"timestamp (s)": times, "Node ID": stations, "TOA (ns)": ns, "Rsrp (dBm)": dbm})


def walk(times, x, y):
    """Where a receiver was."""
    return parquet(**{"timestamp (s)": times, "X (m)": x, "Y (m)": y})


@unittest.skipUnless(READS and importlib.util.find_spec("pyarrow"), "scipy, pandas or pyarrow is not installed")
class Readers(unittest.TestCase):
    def setUp(self):
        self.measured = session([5.0, 5.0, 5.2, 5.2, 5.4], [1, 2, 1, 2, 1], [100, 200, 110, 210, 120], [-60, -70, -61, -71, -62])
        self.stations = parquet(**{"Node ID": [1, 2], "X (m)": [3.0, 0.0], "Y (m)": [0.0, 4.0], "Z (m)": [1.2, 1.2]})

    def test_two_stations_stand_beside_one_another_where_both_measured(self):
        told_of = told(read.pair(self.measured, 1, 2))
        self.assertEqual(told_of["time_s"], [0, 0.2])
        self.assertEqual(told_of["first_m"], [29.979246, 32.97717])
        self.assertEqual(told_of["second_dbm"], [-70, -71])

    def test_distances_are_those_of_told_places(self):
        places = walk([5.2, 6.0], [0.0, 9.0], [0.0, 9.0])
        arrivals, powers, distances = read.at_places(self.measured, places, self.stations)
        self.assertEqual(distances.to_numpy().tolist(), [[3, 4]])
        self.assertEqual(powers[1].tolist(), [-61])
        self.assertEqual(len(arrivals), 1)

    def test_a_clock_is_what_distances_leave_between_places(self):
        places = walk([5.0, 5.4], [0.0, 0.0], [0.0, 0.0])
        late = told(read.clock(self.measured, places, self.stations))
        self.assertEqual(late["time_s"], [0, 0.2])
        self.assertEqual(late["late_m"], [round(150 * 0.299792458 - 3.5, 6), round(160 * 0.299792458 - 3.5, 6)])


if __name__ == "__main__":
    unittest.main()
