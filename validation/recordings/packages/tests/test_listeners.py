"""Readers of the thirtieth set, on small tables that are made here."""

import importlib.util
import unittest

import numpy as np
from tests.made import left_by, told

READS = all(importlib.util.find_spec(name) for name in ("scipy", "pandas"))
if READS:
    import listeners

HEAD = ",".join(["RealTimestamp", *(["WGM701_Voltage (V)", "CVM211_Voltage (V)", "Baratron626D_1KT_Voltage (V)", "Baratron626D_1T_Voltage (V)"])])
RIG = (HEAD + "\n" + "\n".join(f"2025-10-06 10:00:{k:02d}.000,{k},{2 * k},{3 * k},{k / 10}" for k in range(8)) + "\n").encode()
MASSES = b"Sample,Date,Time,Session,d46\nA,2019-04-23,10:00,1,5\nB,2019-04-22,10:00,1,4\nC,2019-04-22,11:00,2,3\n"
SESSIONS = b"UID,Session,d46\n1,B,5\n2,A,6\n3,B,7\n4,A,\n"
BOX = (
    b"Timestamp,BME680_Temp,Temp_LSM9DS1,Pressure,Humidity,Color_C\n"
    b"2025-05-06T10:00:01,20,19,1013,50,5\n2025-05-06T10:00:02,22,19,1013,50,7\n2025-05-06T10:01:00,23,20,1013,50,40\n"
    b"2025-05-06T10:02:00,230,20,1013,50,40\n2025-05-01T10:00:00,20,19,1013,50,5\nnonsense,1,1,1,1,1\n"
)
SHIP = b"datetime\ttemperature\n2013-10-09 19:42:07\t1\n2013-10-09 19:53:07\t2\n2013-10-09 20:04:04\t3\n"
FILMS = b"1 2 3\n10 20 30\n11 21 31\n12 22 32\n"


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_gauges_are_means_of_rows_behind_a_second(self):
        read = listeners.permeation(RIG, 2, "wire_v", "upper_v", begin=1)
        self.assertEqual(told(read), {"time_s": [0, 2, 4], "wire_v": [2.5, 4.5, 6.5], "upper_v": [7.5, 13.5, 19.5]})

    def test_gauges_are_told_while_the_lower_one_is_between_two_volts(self):
        self.assertEqual(told(listeners.permeation(RIG, 1, "lower_v", lower=(0.2, 0.5))), {"time_s": [0, 1], "lower_v": [0.3, 0.4]})

    def test_a_session_is_read_in_the_order_of_its_clock(self):
        self.assertEqual(told(listeners.one_session(MASSES, 1, mass="d46")), {"time_s": [0, 86400], "mass": [4, 5]})

    def test_sessions_are_runs_as_they_come(self):
        self.assertEqual(told(listeners.by_session(SESSIONS, mass="d46")), {"run": [1, 1, 2], "mass": [5, 7, 6]})

    def test_a_box_has_medians_of_minutes_that_are_plausible(self):
        self.assertEqual(told(listeners.box(BOX, "2025-05-0[6-9]", air="BME680_Temp")), {"time_s": [0, 60], "air": [21, 23]})
        self.assertEqual(told(listeners.box(BOX, "2025-05-0[6-9]", least=("Color_C", 20), clear="Color_C")), {"time_s": [0], "clear": [40]})

    def test_a_cruise_from_one_row_to_another(self):
        self.assertEqual(told(listeners.cruise(SHIP, 1, 3, sea="temperature")), {"time_s": [0, 657], "sea": [2, 3]})

    def test_films_are_counted_behind_the_line_of_their_shift(self):
        self.assertEqual(told(listeners.films(FILMS, 0, 2)), {"shift_1_cm": [1, 2, 3], "first": [10, 20, 30], "second": [12, 22, 32]})


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Models(unittest.TestCase):
    def test_a_drift_by_the_logarithm_and_one_to_a_rest_are_found(self):
        t, x = np.arange(0.0, 2000.0, 10), np.random.default_rng(4).normal(size=200)
        self.assertLess(left_by(2 * x + np.log(t + 10), listeners.drifts(2 * x + np.log(t + 10), x, t, 10))["drift by the logarithm"], 1e-9)
        self.assertLess(left_by(2 * x + np.exp(-t / 500), listeners.drifts(2 * x + np.exp(-t / 500), x, t, 10))["drift to a rest"], 1e-6)

    def test_a_background_by_the_place_is_found(self):
        place = np.linspace(50, 900, 100)
        first = 2 + np.exp(-(((place - 200) / 20) ** 2))
        second = 1.5 * first + place / 300
        left = left_by(second, listeners.of_films({"second": second, "first": first, "shift_1_cm": place})[1])
        self.assertLess(left["place"], 1e-9)
        self.assertGreater(left["line"], 0.1)


if __name__ == "__main__":
    unittest.main()
