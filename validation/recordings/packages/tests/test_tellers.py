"""Readers of the twenty-ninth set, on small tables that are made here."""

import gzip
import importlib.util
import json
import struct
import unittest

import numpy as np
from tests.made import left_by, told

READS = all(importlib.util.find_spec(name) for name in ("scipy", "pandas"))
if READS:
    import tellers


def message(name, form, *values):
    """One message of a log: its frame, the name of its channel, a head of 39 bytes, numbers, and a rest that is not read."""
    data = bytes(39) + struct.pack(form, *values) + bytes(5)
    return struct.pack(">IqqII", 0xEDA1DA01, 0, 0, len(name), len(data)) + name.encode() + data


def log(*messages):
    return b"".join(message(*one) for one in messages)


def car(second, height, speed):
    """An inertial message: time, frame, place in three numbers, speed in three."""
    return (*tellers.INERTIAL, int(second * 1e9), 1, 0.1, 0.2, height, 0.6 * speed, 0.8 * speed, 0.0)


LAMPS = b"Primary,Setting,380,381\n0,0,1,2\n0,65,3,4\n1,0,5,6\n1,65,7,8\n"
OTHERS = b"Primary,Setting,380,381\n0,0,1,1\n0,65,2,2\n1,0,3,3\n1,65,4,5\n"
DAYS = b'Timegrid("1989-11-01 00:00:00+01:00",\n         "2021-01-01 00:00:00+01:00",\n         "1d")\n5.5\n6.5\n7.5\n8.5\n'
STACK = b"j,T,V,P,w,time\n20,306.15,2.5,1,,2023-06-22 14:49:00\n10,305.15,2.25,1,,2023-06-22 14:48:00\n"
WAVES = "\ufeffDataset,Beach,Case,Lab/field,Hs [m],Tp [s],tanB [-],D50 [m],Roughness [m],R2% (-SWL) [m]\nA,ONE,1,F,0.5,6,0.1,,,2\nA,TWO,1,F,0.6,7,0.2,,,3\n".encode()
TAKEN = gzip.compress(json.dumps([{}, {"data": [{"pads / hPa": 1, "maads ": 0.1, "pdes / hPa": 3, "mades": 0.4}, {"pads / hPa": 2, "maads ": 0.2, "pdes / hPa": 0, "mades": 0}]}]).encode())


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_pressure_is_told_beside_the_height_and_the_speed_at_its_time(self):
        content = log(car(10, 100, 0), (*tellers.BAROMETER, 11 * 10**9, 98000.0), car(12, 110, 10), (*tellers.BAROMETER, 12 * 10**9, 97900.0))
        read = tellers.drive_by_pressure(content)
        self.assertEqual(told(read), {"time_s": [0, 1], "height_m": [105, 110], "speed_m_s": [5, 10], "pressure_hpa": [980, 979]})

    def test_two_speeds_are_told_at_the_times_of_the_receiver(self):
        ways = [(*tellers.RECEIVER, k * 10**9, 1, 0.1, 0.2, 0.0, 3.0 * k, 4.0 * k, 0.0) for k in (1, 2, 3)]
        read = tellers.drive_by_speed(log(car(0, 0, 0), car(4, 0, 8), *ways), 1, 3)
        self.assertEqual(told(read), {"time_s": [0, 1], "inertial_m_s": [4, 6], "receiver_m_s": [10, 15]})

    def test_what_is_felt_is_summed_over_seconds_that_are_fast_enough(self):
        cars = [car(k, 10 * k if k > 2 else 20, 2 * k) for k in range(6)]
        felt = [(*tellers.ACCELEROMETER, k * 10**9, 0, 0.5, 0.0, 0.0) for k in range(6)]
        read = tellers.drive_by_force(log(*cars, *felt), 4)
        self.assertEqual(told(read), {"time_s": [2, 3], "gained_m_s2": [2, 2], "slope": [2, 1.428571], "felt_m_s2": [0.5, 0.5]})

    def test_a_lamp_has_all_its_wavelengths_together(self):
        self.assertEqual(told(tellers.setting(LAMPS, 1)), {"setting": [0, 65], "light": [11, 15]})
        self.assertEqual(told(tellers.two_lamps(LAMPS, OTHERS, 0)), {"first": [3, 7], "second": [2, 4]})

    def test_days_begin_behind_a_head(self):
        read = tellers.valley(DAYS, DAYS, first=1, days=2, names=("rain", "water"))
        self.assertEqual(told(read), {"time_s": [0, 86400], "rain": [6.5, 7.5], "water": [6.5, 7.5]})

    def test_a_stack_is_read_in_the_order_of_its_clock(self):
        self.assertEqual(told(tellers.stack(STACK)), {"time_s": [0, 60], "current_ma_cm2": [10, 20], "warmth_degc": [32, 33], "volts": [2.25, 2.5]})

    def test_one_beach_of_a_table_with_a_mark_of_its_order(self):
        self.assertEqual(told(tellers.runup(WAVES, "TWO")), {"height_m": [0.6], "slope": [0.2], "period_s": [7], "runup_m": [3]})

    def test_branches_follow_one_another_without_the_zeros_that_fill_them_up(self):
        x, y = tellers.sorption(TAKEN, 1, ("pads / hPa", "maads"), ("pdes / hPa", "mades"))
        self.assertEqual((x.tolist(), y.tolist()), ([1, 2, 3], [0.1, 0.2, 0.4]))


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Models(unittest.TestCase):
    def test_a_corner_and_a_power_are_found(self):
        x = np.linspace(0.1, 10, 100)
        self.assertLess(left_by(2 * x - np.maximum(x - 6, 0), tellers.one_side(2 * x - np.maximum(x - 6, 0), x, 5.0))["corner"], 0.01)
        self.assertLess(left_by(3 * x**0.6, tellers.one_side(3 * x**0.6, x, 5.0))["power"], 1e-6)

    def test_gains_by_two_drivers_are_found_beside_one_another(self):
        x, a, b = np.random.default_rng(3).normal(size=(3, 200))
        left = left_by(x * (2 + a - b), tellers.gains(x * (2 + a - b), x, a=a, b=b))
        self.assertLess(left["gains by a and b"], 1e-9)
        self.assertGreater(left["gain by a"], 0.5)


if __name__ == "__main__":
    unittest.main()
