"""Readers of the twenty-third set, on small tables that are made here."""

import gzip
import importlib.util
import io
import json
import lzma
import pickle
import unittest

import numpy as np
from tests.made import told

READS = all(importlib.util.find_spec(name) for name in ("scipy", "pandas"))
if READS:
    import counters
    from fitting import play


def pickled_array(values):
    """A spectrum as pyepri keeps it."""
    return pickle.dumps({"B": np.arange(len(values)), "DAT": np.array(values, np.float32), "PARAM": None})


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_minutes_of_a_house_become_means_and_one_that_lacks_a_number_is_left_out(self):
        head = "Date,Time,Global_active_power,Global_reactive_power,Voltage,Global_intensity,Sub_metering_1"
        minutes = ["4/2/2007,23:59:00,9,9,9,9,0", *(f"5/2/2007,00:0{k}:00,{k},0.{k},24{k},{4 * k},0" for k in range(4)), "5/2/2007,00:04:00,?,?,?,?,?", "5/2/2007,00:05:00,1,1,1,1,0"]
        read = counters.house(lzma.compress("\n".join([head, *minutes]).encode()), "2007-02-05", "2007-02-06", 2)
        self.assertEqual(told(read), {"power_kw": [0.5, 2.5], "reactive_kvar": [0.05, 0.25], "voltage_v": [240.5, 242.5], "current_a": [2, 10]})

    def test_walls_are_read_between_two_dates(self):
        content = lzma.compress(b"date,T6,T_out\n2016-03-27 23:50:00,1,2\n2016-03-28 00:00:00,3,4\n2016-03-28 00:10:00,5,6\n2016-03-28 00:20:00,7,8\n2016-03-29 00:00:00,9,9\n")
        read = counters.walls(content, "2016-03-28", "2016-03-29", 2)
        self.assertEqual(told(read), {"time_s": [0, 1200], "airport_degc": [4, 8], "wall_degc": [3, 7]})

    def test_a_magnetometer_is_read_where_it_has_measured(self):
        content = b"[Header]\nx\n[Data]\nComment,Moment (emu)\n,\n,2\n,3\n,4\n"
        self.assertEqual(counters.moments(content, 2)["Moment (emu)"].tolist(), [2, 4])

    def test_ions_are_found_by_the_head_two_lines_above_the_table(self):
        content = b"\ttotal\tGa+\t^71Ga+\n\t\t68.9\t70.9\nSputter Time (s)\tIntensity\tIntensity\tIntensity\n4.0\t1\t2\t3\t\n6.0\t4\t5\t6\t\n8.0\t7\t8\t9\t\n"
        self.assertEqual([list(values) for values in counters.sputtered(content, "", "^71Ga+", "Ga+")], [[6, 8], [6, 9], [5, 8]])

    def test_each_file_of_a_cell_is_a_run(self):
        file = lambda *rows: ("\ufeffSample name: \tS\nFrequency [Hz]\tC [nF]\tTemperature [K]\tRp [Ohm]\n\n" + "\n".join(rows) + "\n").encode()
        read = counters.capacitances(file("100\t5\t123.1\t9", "1000\t4\t123.2\t9"), file("10\t6\t133\t9"))
        self.assertEqual(told(read), {"run": [1, 1, 2], "decades": [2, 3, 1], "cell_k": [123.1, 123.2, 133], "capacitance_nf": [5, 4, 6]})

    def test_a_cell_that_is_kept_hot_is_left_out_while_it_has_less_light(self):
        content = 'a\nb\nc\n"Measurement No";"Time";"Pmp [mW/cm^2]";"Illumination"\n1;00:00:00:00;5;5.8\n2;00:00:30:01;0;0.1\n3;01:02:00:05;4;5.8\n'.encode()
        self.assertEqual(told(counters.kept_hot(content, least=5)), {"time_s": [0, 93605], "power_mw_cm2": [5, 4]})

    def test_each_warmth_and_frequency_of_a_ferrite_is_a_run(self):
        rows = [{"temperature": 30, "frequency": 100000, "flux_density": [0, 0.1], "mu_phi_deg": [1, 2]}, {"temperature": 30, "frequency": 200000, "flux_density": [0.2], "mu_phi_deg": [3]}]
        content = json.dumps({"N49": {"measurements": {"complex_permeability": {"LEA_LK": {"measurement_data": rows}}}}}).encode()
        self.assertEqual(told(counters.ferrite(content, "N49", 0.01)), {"run": [1, 2], "frequency_khz": [100, 200], "flux_t": [0.1, 0.2], "angle_deg": [2, 3]})

    def test_days_of_a_road_that_lack_something_are_left_out(self):
        content = gzip.compress(b"date,no2,bg.no2,ws,wd\n2001-01-01 00:00:00,4,1,2,9\n2001-01-01 12:00:00,6,3,4,9\n2001-01-02 00:00:00,5,,1,9\n2001-01-03 00:00:00,7,5,6,9\n")
        self.assertEqual(told(counters.road(content)), {"time_s": [0, 172800], "background": [2, 5], "wind_m_s": [3, 6], "road": [5, 7]})

    def test_any_kind_of_event_was_shown(self):
        self.assertEqual(told(counters.events(b"bold,events\n0.5,0\n-0.5,4\n", 2)), {"time_s": [0, 2], "shown": [0, 1], "signal": [0.5, -0.5]})

    def test_evaporation_is_read_from_a_year_to_before_another(self):
        lines = "1 1 2011 0 9 0 9\n31 12 2012 0 1 0 2\n1 1 2013 0 9 0 9\n2 1 2013 0 3 0 4\n1 1 2014 0 9 0 9\n"
        read = counters.evaporation(f"Day Month Year Tmin(C) Tmax(C) Prcp(mm) Et0(mm)\n{lines}".encode(), 2012, 2014, 2)
        self.assertEqual(told(read), {"time_s": [0, 172800], "warmest_degc": [1, 3], "evaporation_mm": [2, 4]})

    def test_a_glow_is_of_one_colour_under_others(self):
        out = io.BytesIO()
        np.save(out, np.arange(2 * 2 * 2 * 3).reshape(2, 2, 2, 3))
        first, second = counters.glow(out.getvalue(), [1], 0, 0, 1)
        self.assertEqual([first.tolist(), second.tolist()], [[[12, 13, 14]], [[15, 16, 17]]])

    def test_spectra_of_radicals_are_thinned(self):
        read = counters.radicals(pickled_array([1, 2, 3]), pickled_array([4, 5, 6]), every=2)
        self.assertEqual([values.tolist() for values in read], [[1, 3], [4, 6]])


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Models(unittest.TestCase):
    def test_memory_starts_afresh_in_each_run(self):
        run, t, x = np.array([1, 1, 2, 2]), np.array([0.0, 1, 5, 7]), np.array([1.0, 2, 3, 4])
        self.assertEqual(counters.in_runs(run, t, lambda rows, s: s).tolist(), [0, 1, 0, 2])
        self.assertEqual(counters.in_runs(run, t, lambda rows, s: x[rows] - x[rows][0]).tolist(), [0, 1, 0, 1])

    def test_play_stands_until_it_is_pushed_or_pulled(self):
        self.assertEqual(play(np.array([0.0, 0.5, 3, 2, 0]), 1).tolist(), [0, 0, 2, 2, 1])


if __name__ == "__main__":
    unittest.main()
