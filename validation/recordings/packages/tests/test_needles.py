"""Readers of the twenty-seventh set, on small tables that are made here."""

import importlib.util
import unittest

import numpy as np
from tests.made import told

READS = all(importlib.util.find_spec(name) for name in ("scipy", "pandas"))
if READS:
    import needles


FLIGHT = b"ts,fan,fuel\n1,10,0.1\n2,20,\n3,30,0.3\n4,40,0.4\n5,50,0.5\n6,60,0.6\n"
ENGINES = b"uid,type,bpr,max_thrust,ff_to\na,TF,2,15600,0.2\nb,MTF,3,20000,0.3\nc,TF,,30000,0.4\nd,TF,5,40000,0.5\n"
EXERCISE = b",time,VO2_I,HR_I\n0,5,900,80\n1,6,950,81\n2,7,1000,82\n3,8,1050,83\n"
RIVER = b"datetime,Qcms,turb\n2020-01-01 00:00:00+00:00,1,10\n2020-01-01 00:15:00+00:00,2,20\n2020-01-01 00:30:00+00:00,3,\n2020-01-01 00:45:00+00:00,4,40\n2020-01-01 01:00:00+00:00,5,50\n"
EVENTS = b"start,end\n2019-01-01 00:00:00+0000,2019-01-02 00:00:00+0000\n2020-01-01 00:10:00+0000,2020-01-01 00:50:00+0000\n"
PLANT = b",tag0,tag1,tag2\n2017-12-24 00:00:00,1,2,3\n2017-12-24 00:05:00,4,5,Inp OutRange\n"
SURVEY = b"""/
/   LINE FLIGHT FTIME MGA-X RALT FA
 Line 7.01
 7.01 3 100.0 0 10 0
 7.01 3 100.5 10 20 1
 7.01 3 101.0 20 30 2
 Line 7.02
 7.02 3 200.0 25 35 9
 7.02 3 200.5 15 25 2.5
 7.02 3 201.0 5 15 1.5
"""


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_flight_is_read_where_all_columns_have_numbers(self):
        read = needles.flight(FLIGHT, 1, 2, {"kg_h": 3600}, fan_percent="fan", kg_h="fuel")
        self.assertEqual(told(read), {"time_s": [0, 2], "fan_percent": [30, 50], "kg_h": [1080, 1800]})

    def test_engines_that_mix_their_streams_are_left_out(self):
        self.assertEqual(told(needles.engines(ENGINES)), {"bypass": [2, 5], "thrust_kn": [15.6, 40], "fuel_kg_s": [0.2, 0.5]})

    def test_an_exercise_test(self):
        self.assertEqual(told(needles.exercise(EXERCISE, 3, oxygen="VO2_I", heart="HR_I")), {"time_s": [0, 3], "oxygen": [900, 1050], "heart": [80, 83]})

    def test_a_storm_is_read_between_its_begin_and_its_end(self):
        self.assertEqual(told(needles.storm(RIVER, EVENTS, 1)), {"time_s": [0, 1800], "flow_m3_s": [2, 4], "turbidity_fnu": [20, 40]})

    def test_lines_of_a_survey_are_runs(self):
        self.assertEqual(told(needles.survey(SURVEY, radar="RALT")), {"run": [1, 1, 1, 2, 2, 2], "time_s": [0, 0.5, 1, 100, 100.5, 101], "radar": [10, 20, 30, 35, 25, 15]})

    def test_a_line_that_was_flown_again_is_put_beside_the_first_at_the_same_places(self):
        self.assertEqual(told(needles.flown_again(SURVEY, 1, "FA")), {"run": [1, 1], "first_mgal": [0.5, 1.5], "again_mgal": [1.5, 2.5]})

    def test_patches_are_read_at_the_wavelengths_that_both_charts_have(self):
        first, second = b"wavelength,1,2\n380,0.1,0.2\n385,9,9\n390,0.3,0.4\n", b"wavelength,1,2\n380,0.5,0.6\n390,0.7,0.8\n400,9,9\n"
        read = needles.charts(first, second)
        self.assertEqual(told(read), {"run": [1, 1, 2, 2], "nm": [380, 390, 380, 390], "first": [0.1, 0.3, 0.2, 0.4], "second": [0.5, 0.7, 0.6, 0.8]})

    def test_words_in_a_plants_table_are_no_numbers(self):
        read = needles.plant(PLANT, first="tag0", second="tag2")
        self.assertEqual(told({name: read[name] for name in ("time_s", "first")}), {"time_s": [0, 300], "first": [1, 4]})
        self.assertTrue(np.isnan(read["second"].iloc[1]))


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Models(unittest.TestCase):
    def test_a_mean_over_rows_stays_inside_of_its_run(self):
        self.assertEqual(needles.over_rows(np.array([1.0, 2, 6, 10, 20]), np.array([1, 1, 1, 2, 2]), 3).tolist(), [1.5, 3, 4, 15, 15])

    def test_a_zero_that_changes_is_found_where_it_does(self):
        t, rng = np.arange(400.0), np.random.default_rng(1)
        x = rng.uniform(1, 2, 400)
        y = 2 * x + 3 * (t > 250)
        seen = np.ones(400, bool)
        self.assertLess(np.std(y - needles.changed(y, t, [x], np.ones(400))(seen)), 1e-9)
        self.assertGreater(np.std(y - needles.changed(y, t, [x], x)(seen)), 0.01)

    def test_a_day_is_found_beside_a_zero_that_changes(self):
        t, rng = np.arange(0, 6 * 86400, 1800.0), np.random.default_rng(2)
        x = rng.normal(size=len(t))
        y = x + np.sin(2 * np.pi * t / 86400) + (t > 4 * 86400)
        seen = np.ones(len(t), bool)
        left = {name: np.std(y - model(seen)) for name, model in needles.days(y, x, t).items()}
        self.assertLess(left["day, and step"], 1e-9)
        self.assertGreater(left["day"], 0.1)


if __name__ == "__main__":
    unittest.main()
