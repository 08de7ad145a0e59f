"""Readers of the twenty-fifth set, on small tables that are made here."""

import importlib.util
import io
import unittest

import numpy as np
from tests.made import told

READS = all(importlib.util.find_spec(name) for name in ("scipy", "pandas"))
if READS:
    import scales
    from scipy.io import savemat


def person(*trials):
    """A file of a person whose trials are told as bouts of cameras and of sensors."""
    out = io.BytesIO()
    seen = {f"Trial{k}": {"Standards": {way: {"MicroWB": bout} for way, bout in trial.items()}} for k, trial in enumerate(trials, 1)}
    savemat(out, {"data": {"TimeMeasure1": {"Test5": seen}}})
    return out.getvalue()


def bout(contacts, lengths):
    """A bout of strides."""
    return {"Stride_InitialContacts": np.array(contacts, float), "Stride_Length": np.array(lengths, float)}


STATION = "yyyy/mm/dd hh:mm\tBn\tElev.Sol\n2020/03/04 07:00\t1\tNaN\n2020/03/04 07:01\t2\t5\n2020/03/04 07:02\t3\t6\n2020/03/04 07:03\t4\t7\n"
MODULE = """Date Time,DNI (W/m2),T_Amb (\xb0C),Wind Speed (m/s),Wind Dir. (m/s),T_Backplane (\xb0C)
01-Jun-2019 06:00:00,   500.0, 20.0, 1.0, 90.0, 30.0
02-Jun-2019 06:00:00,    50.0, 20.0, 1.0, 90.0, 30.0
02-Jun-2019 06:01:01,   500.0, 21.0, 2.0, 90.0, 31.0
02-Jun-2019 06:02:02,   500.0, 22.0, 3.0, 90.0, 32.0
"""
WATCH = """<trkpt lat="48.5" lon="2.5">
  <ele>51.8</ele>
  <time>2021-07-01T00:00:10Z</time></trkpt><trkpt lat="48.6" lon="2.4"><ele>5</ele><time>2021-07-01T00:00:11.5Z</time></trkpt>
"""
COUNTS = """date,hour,year,1 Here Street,2 There Street
2019-06-01,7:00-7:59,2019,5,6
2019-06-01,6:00-6:59,2019,3,4
2019-06-01,8:00-8:59,2019,5,
2019-06-02,6:00-6:59,2019,7,8
"""
BOTTLES = b"""* heading (avg)x
  Btl_Posn        Date       PrDM    C0mS/cm
      1    Feb 26 2018     10.25   7.5 (avg)
     27       08:32:41      0.219   0.1 (sdev)
      2    Feb 26 2018     20.5   8.5 (avg)
"""
FARM = b"""* 1989 a comment of nine words that is left away here
   5.67  51.97     7.  -0.18 -0.55
   1 1992   1   350.   3.6   8.1   0.800   5.8   0.0
   1 1992   2   760.   5.5   7.3   0.790   6.3   0.0
"""


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_station_is_read_where_the_sun_is_high_enough(self):
        self.assertEqual(told(scales.sunny_station(STATION.encode(), 5, sun="Bn")), {"time_s": [0, 60], "sun": [3, 4]})
        self.assertEqual(told(scales.sunny_station(STATION.encode(), sun="Bn")), {"time_s": [0, 60, 120, 180], "sun": [1, 2, 3, 4]})

    def test_a_module_is_read_between_two_days_in_the_sun(self):
        read = scales.module(MODULE.encode("latin1"), "2019-06-02", "2019-06-05", 100)
        self.assertEqual(told(read), {"time_s": [0, 61], "air_degc": [21, 22], "wind_m_s": [2, 3], "back_degc": [31, 32]})

    def test_points_of_a_watch(self):
        t, north, east = scales.watch(WATCH.encode())
        self.assertEqual((t.tolist(), north.tolist(), east.tolist()), ([10, 11.5], [48.5, 48.6], [2.5, 2.4]))

    def test_a_receiver_tells_places_from_the_middle_of_the_earth(self):
        lines = "% heading\n2021/07/01 00:00:01.000 6378137.0 0.0 0.0 5\n2021/07/01 00:00:02.000 0.0 4517590.8789 4487348.4088 5\n"
        t, north, east = scales.receiver(lines.encode())
        self.assertEqual((t.tolist(), north.round(6).tolist(), east.tolist()), ([1, 2], [0, 45], [0, 90]))

    def test_two_tracks_are_put_together_in_metres(self):
        first = np.arange(0.0, 40, 2), np.arange(0.0, 40, 2) / scales.DEGREE, np.zeros(20)
        second = np.arange(0.0, 60, 3) + 10, np.arange(0.0, 60, 3) / scales.DEGREE, np.zeros(20)
        read = scales.together(first, second, "north", 2, late=10)
        self.assertEqual(told(read), {"time_s": [0, 6, 12, 18, 24], "first_m": [-13.5, -7.5, -1.5, 4.5, 10.5], "second_m": [-13.5, -7.5, -1.5, 4.5, 10.5]})

    def test_counters_are_read_in_the_order_of_time(self):
        read = scales.passers_by(COUNTS.encode(), "2019-06-01", "2019-06-02", here="1 Here Street", there="2 There Street")
        self.assertEqual(told(read), {"time_s": [0, 3600], "here": [3, 5], "there": [4, 6]})

    def test_bottles_of_two_casts(self):
        read = scales.bottles(BOTTLES, BOTTLES, dbar=0, ms_cm=1)
        self.assertEqual(told(read), {"run": [1, 1, 2, 2], "dbar": [10.25, 20.5, 10.25, 20.5], "ms_cm": [7.5, 8.5, 7.5, 8.5]})

    def test_strides_are_paired_where_they_begin_and_end_together(self):
        cameras, worn = bout([[1, 2], [2, 3.5], [4, 5]], [1.1, np.nan, 1.3]), bout([[105, 205], [200, 350], [430, 500]], [1.2, 1.4, 1.5])
        read = scales.strides(person({"Stereophoto": cameras, "INDIP": worn}, {"INDIP": worn}, {"Stereophoto": bout([], []), "INDIP": worn}), apart=0.12)
        self.assertEqual(told(read), {"cameras_m": [1.1], "worn_m": [1.2]})

    def test_one_kind_of_tissue_near_some_wavenumbers(self):
        content = b"type,1700.0,1650.0,1600.0\nd,c,c,c\nclass,,,\ncollagen,0.1,0.2,0.3\nDNA,1,1,1\ncollagen,0.4,0.5,0.6\n"
        self.assertEqual(told(scales.tissue(content, "collagen", one=1655, two=1540)), {"one": [0.2, 0.5], "two": [0.3, 0.6]})

    def test_a_probe_is_asked_as_a_satellite_passes(self):
        probe = b"date_time,soil_moisture,soil_moisture_flag\n2017-01-01 00:00:00,0.5,G\n2017-01-01 01:00:00,0.9,D04\n2017-01-01 02:00:00,0.4,G\n"
        satellite = b",sm,snow\n2016-12-31 20:00:00,30,\n2017-01-01 00:10:00,35,\n2017-01-01 01:00:00,36,\n2017-01-01 01:40:00,37,\n2017-01-01 02:00:00,,\n"
        self.assertEqual(told(scales.wet_soil(probe, satellite, 35)), {"time_s": [0, 5400], "satellite_percent": [35, 37], "probe_m3_m3": [0.5, 0.4]})

    def test_days_of_a_farm(self):
        read = told(scales.farm_days(FARM, FARM.replace(b" 1992   1", b" 1993   1").replace(b" 1992   2", b" 1993   2")))
        self.assertEqual(read["time_s"], [0, 86400, 366 * 86400, 367 * 86400])
        self.assertEqual([values[:2] for values in read.values()][1:], [[3.6, 5.5], [0.35, 0.76], [0.8, 0.79], [8.1, 7.3]])


if __name__ == "__main__":
    unittest.main()
