"""Files of the package pntos-cobra-datasets-lcm, read from small ones that are made here."""

import struct
import unittest

from tests.made import READS, told

if READS:
    from readers import pntos_cobra_datasets_lcm


def message(name, form, *values):
    """One message of a log: its frame, the name of its channel, a head of 39 bytes, numbers, and a rest that is not read."""
    data = bytes(39) + struct.pack(form, *values) + bytes(5)
    return struct.pack(">IqqII", 0xEDA1DA01, 0, 0, len(name), len(data)) + name.encode() + data


def log(*messages):
    return b"".join(message(*one) for one in messages)


def car(second, height, speed):
    """An inertial message: time, frame, place in three numbers, speed in three."""
    return (*pntos_cobra_datasets_lcm.INERTIAL, int(second * 1e9), 1, 0.1, 0.2, height, 0.6 * speed, 0.8 * speed, 0.0)


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_pressure_is_told_beside_the_height_and_the_speed_at_its_time(self):
        content = log(car(10, 100, 0), (*pntos_cobra_datasets_lcm.BAROMETER, 11 * 10**9, 98000.0), car(12, 110, 10), (*pntos_cobra_datasets_lcm.BAROMETER, 12 * 10**9, 97900.0))
        read = pntos_cobra_datasets_lcm.drive_by_pressure(content)
        self.assertEqual(told(read), {"time_s": [0, 1], "height_m": [105, 110], "speed_m_s": [5, 10], "pressure_hpa": [980, 979]})

    def test_two_speeds_are_told_at_the_times_of_the_receiver(self):
        ways = [(*pntos_cobra_datasets_lcm.RECEIVER, k * 10**9, 1, 0.1, 0.2, 0.0, 3.0 * k, 4.0 * k, 0.0) for k in (1, 2, 3)]
        read = pntos_cobra_datasets_lcm.drive_by_speed(log(car(0, 0, 0), car(4, 0, 8), *ways), 1, 3)
        self.assertEqual(told(read), {"time_s": [0, 1], "inertial_m_s": [4, 6], "receiver_m_s": [10, 15]})

    def test_what_is_felt_is_summed_over_seconds_that_are_fast_enough(self):
        cars = [car(k, 10 * k if k > 2 else 20, 2 * k) for k in range(6)]
        felt = [(*pntos_cobra_datasets_lcm.ACCELEROMETER, k * 10**9, 0, 0.5, 0.0, 0.0) for k in range(6)]
        read = pntos_cobra_datasets_lcm.drive_by_force(log(*cars, *felt), 4)
        self.assertEqual(told(read), {"time_s": [2, 3], "gained_m_s2": [2, 2], "slope": [2, 1.428571], "felt_m_s2": [0.5, 0.5]})


if __name__ == "__main__":
    unittest.main()
