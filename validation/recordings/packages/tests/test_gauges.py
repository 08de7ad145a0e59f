"""Readers of the twenty-second set, on small tables that are made here."""

import gzip
import importlib.util
import io
import unittest

import numpy as np
from tests.made import told

READS = all(importlib.util.find_spec(name) for name in ("scipy", "pandas"))
if READS:
    import gauges
    from fitting import line


def written(table, **options):
    """A table of numbers as the bytes of a file."""
    out = io.BytesIO()
    np.savetxt(out, table, **{"delimiter": ",", **options})
    return out.getvalue()


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_film_is_thinned_in_both_directions_and_knows_its_place(self):
        dose = np.arange(12.0).reshape(3, 4)
        read = told(gauges.film(written(dose + 100), written(dose), millimetres=2, every=2))
        self.assertEqual(read, {"place_mm": [0, 0, 4, 4], "planned_gy": [0, 2, 8, 10], "film_gy": [100, 102, 108, 110]})

    def test_a_spring_is_read_by_its_means_and_without_days_that_lack_one(self):
        head = "Datetime,USGS_1_2_00010_00001:degC,USGS_1_3_00010_00003:degC,USGS_1_4_00065_00003:ft"
        read = gauges.spring(f"{head}\n2020-01-01,9,20,1\n2020-01-02,9,,2\n2020-01-03,9,22,10\n".encode(), "water_degc", "stage_m")
        self.assertEqual(told(read), {"water_degc": [20, 22], "stage_m": [0.3048, 3.048], "time_s": [0, 172800]})

    def test_thermometers_are_told_in_celsius_between_two_dates(self):
        content = "\ufeffDate,A,B\n1/1/1950,0,0\n1/2/1950,32,50\n1/3/1950,0,0\n1/4/1950,212,14\n1/5/1950,0,0\n".encode()
        read = gauges.thermometers(content, "A", "B", "1950-01-02", "1950-01-04", every=2)
        self.assertEqual(told(read), {"time_s": [0, 172800], "there_degc": [0, 100], "here_degc": [10, -10]})

    def test_hours_without_a_number_are_left_out(self):
        content = gzip.compress(b",temp,precip,hum,glob,wind\n2014-05-01 00:00:00,5,0,90,0,1\n2014-05-01 01:00:00,,0,91,0,1\n2014-05-01 02:00:00,7,0,80,3,1\n2014-06-01 00:00:00,9,0,70,0,1\n")
        read = gauges.hours(content, "2014-05", "2014-05")
        self.assertEqual(told(read), {"time_s": [0, 7200], "air_degc": [5, 7], "sun_w_m2": [0, 3], "humidity_percent": [90, 80]})

    def test_a_band_is_the_one_that_is_next_to_a_wavenumber(self):
        read = gauges.bands(written([[1000, 1003, 1006], [1, 2, 3], [4, 5, 6]]), 75, 1004, 1000)
        self.assertEqual(told(read), {"time_s": [0, 75], "band_1004": [2, 5], "band_1000": [1, 4]})

    def test_exposures_of_two_fields_go_together_where_they_follow_soon_and_are_sharp(self):
        first = b"1.000 18.0 0.01\n2.000 18.1 0.01\n3.000 18.2 0.90\n"
        second = b" 1.010 17.9 0.02\n 2.200 18.0 0.02\n 3.001 18.1 0.02\n 1.990 18.3 0.02\n"
        read = gauges.two_fields(first, second, apart=1000, worst=0.1)
        self.assertEqual(told(read), {"time_s": [0, 84672], "first_mag": [18, 18.1], "second_mag": [17.9, 18.3]})

    def test_darkness_is_found_by_its_exposure(self):
        content = written([[0, 400, 401], [0.003, 10, 11], [2, 20, 22]])
        self.assertEqual([list(counts) for counts in gauges.darkness(content, 2, 0.003)], [[20, 22], [10, 11]])

    def test_polarised_neutrons_know_their_direction_and_how_far_they_were_turned(self):
        table = np.array([[0.03, 0.0, 5, 1], [0.0, 0.04, 6, 1], [0.3, 0.4, 7, 1], [0.03, 0.04, -1, 1]])
        head = {"delimiter": "\t", "header": "ASCII data\n", "comments": ""}
        read = gauges.polarised(written(table, **head), written(table * [1, 1, 2, 1], **head), widest=0.1, every=1)
        self.assertEqual(told(read), {"across": [0, 1], "way_1_nm": [0.3, 0.4], "against": [10, 12], "along": [5, 6]})

    def test_pixels_under_a_grating_are_rows(self):
        out = io.BytesIO()
        np.savez(out, probe=np.arange(6.0).reshape(2, 3), wl=np.zeros((2, 3)))
        self.assertEqual(gauges.grating(out.getvalue(), 2, 0).tolist(), [[2, 5], [0, 3]])


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Models(unittest.TestCase):
    def test_a_shift_that_changes_is_found(self):
        t = np.arange(400.0)
        x, late = np.sin(t / 9), lambda by: np.sin((t - by) / 9)
        y = 3 + 2 * late(5 - 2 * (t / t[-1] - 0.5))
        models, seen = gauges.later(y, x, t, 1, 4.0), t > 30
        error = {name: np.abs(models[name](seen) - y)[seen].max() for name in ("shift from there", "shift that changes")}
        self.assertLess(error["shift that changes"], 0.02)
        self.assertGreater(error["shift from there"], 0.1)

    def test_a_step_takes_what_was_switched(self):
        t = np.arange(50.0)
        x = np.cos(t)
        y = x + 3 * (t > 20)
        seen = np.ones(50, bool)
        self.assertLess(np.abs(gauges.switches(y, x, t, 20)["step"](seen) - y).max(), 1e-9)
        self.assertGreater(np.abs(line(y, x)(seen) - y).max(), 1)


if __name__ == "__main__":
    unittest.main()
