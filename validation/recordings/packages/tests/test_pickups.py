"""Readers of the twenty-fourth set, on small tables that are made here."""

import importlib.util
import io
import struct
import unittest

import numpy as np
from tests.made import told

READS = all(importlib.util.find_spec(name) for name in ("scipy", "pandas"))
if READS:
    import pickups
    import rigs
    from scipy.io import savemat


def matlab(**variables):
    """A file of variables."""
    out = io.BytesIO()
    savemat(out, variables)
    return out.getvalue()


def record(station, channel, values):
    """One record of miniSEED with floating numbers, 256 bytes long."""
    head = bytearray(64)
    head[8:20] = f"{station:5}1 {channel}1 ".encode()
    struct.pack_into(">H", head, 30, len(values))
    struct.pack_into(">H", head, 44, 64)
    head[54] = 8
    return (bytes(head) + np.array(values, ">f4").tobytes()).ljust(256, b"\0")


DRYER = b"""batch_id,AgitatorPower,JacketTemperatureSP,JacketTemperature,DryerTemp,ClockTime
1,9,60,84,70,0
1,9,60,84,75,1
1,9,60,84,80,2
1,9,-5,50,81,3
1,9,0,20,79,4
2,9,0,16,80,0
3,9,0,16,80,0
"""


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_channels_of_a_basin_are_found_by_their_names(self):
        content = matlab(data=np.array([[5.0, 1, 2], [5.5, 3, 4]]), chan_names=np.array(["Time", "WAVE", "YAW"], object))
        self.assertEqual(told(pickups.basin(content, yaw_deg="YAW")), {"time_s": [0, 0.5], "yaw_deg": [2, 4]})

    def test_channels_of_a_towing_tank_are_variables(self):
        content = matlab(Time=np.array([3.0, 3.25]), FX=np.array([7.0, 8]))
        self.assertEqual(told(pickups.towed(content, force_n="FX")), {"time_s": [0, 0.25], "force_n": [7, 8]})

    def test_what_turns_adds_up_from_the_first_row_on(self):
        self.assertEqual(rigs.summed(np.array([0.0, 2, 2]), np.array([0.0, 1, 3])).tolist(), [0, 1, 5])

    def test_a_press_is_read_in_steps_of_its_converters(self):
        table = np.array([[10000, 10000, 5000, 5000], [0, 100, 200, 300], [0, 1000, 2000, 3000], [0, 10, 20, 30], [0, 0, 0, 0]], ">f4")
        content = b"p1".ljust(20, b"\0") + struct.pack(">ii", 4, 5) + b"\0" * 100 + table.tobytes()
        for beside, values in (("shear_mpa", [1.597779, 4.793337]), ("layer_um", [1.101718, 3.305153])):
            read = told(pickups.press(content, beside, first=1, last=4, every=2))
            self.assertEqual(read, {"time_s": [0, 1], "slip_um": [7.6472, 22.9416], beside: values})

    def test_a_dryer_is_read_from_some_rows_before_its_jacket_is_cooled(self):
        read = pickups.cooled(DRYER, 1, 2, before=1)
        self.assertEqual(told(read), {"run": [1, 1, 1, 2], "time_s": [120, 180, 240, 0], "jacket_degc": [84, 50, 20, 16], "product_degc": [80, 81, 79, 80]})

    def test_a_foot_pitches_by_heel_and_toe(self):
        heights = np.tan(np.radians([0, 1, 2, 3]))
        rows = "\n".join(f"{k},10,0,{heights[k]},9,0,0" for k in range(4))
        markers = f",L_TOE,L_TOE,L_TOE,L_FCC,L_FCC,L_FCC\n,x,y,z,x,y,z\n{rows}\n"
        sensors = "sensor,left_sensor,left_sensor\naxis,gyr_y,gyr_z\n" + "\n".join(f"{k},{k},{-k}" for k in range(9)) + "\n"
        read = told(pickups.foot(markers.encode(), sensors.encode(), "left"))
        self.assertEqual(read["markers"], [-100, -100, -100, -100])
        self.assertEqual((read["gyro"], read["twist"]), ([0, 2.048, 4.096, 6.144], [0, -2.048, -4.096, -6.144]))

    def test_a_wrist_sensor_begins_after_a_hundred_lines(self):
        rows = "\n".join(f"2019-08-06 10:25:50:{k:03},0,0,0,0,0,{30 + k / 100}" for k in (0, 20, 40, 60))
        self.assertEqual(told(pickups.wrist(("x\n" * 100 + rows + "\n").encode(), 2)), {"time_s": [0, 0.04], "sensor_degc": [30, 30.4]})

    def test_a_radio_is_as_far_as_the_robot_is_from_it(self):
        way = np.array([[10.0, 0, 0, 0], [12, 6, 8, 0]])
        heard = np.array([[12.0, 2, 7, 11], [10, 2, 7, 1], [11, 2, 5, 4]])
        read = pickups.ranges(matlab(GT=way, TD=heard, TL=np.array([[7.0, 0, 0], [5, 3, 0]])))
        self.assertEqual(told(read), {"time_s": [0, 1, 2], "apart_m": [0, 4, 10], "radio_m": [1, 4, 11]})

    def test_vertical_channels_of_two_geophones(self):
        content = record("5", "DPZ", [1, 2]) + record("5", "DPE", [9, 9]) + record("12", "DPZ", [5, 6]) + record("5", "DPZ", [3, 4]) + record("12", "DPZ", [7, 8])
        self.assertEqual(told(pickups.geophones(content, 3, 250, nearer="5", farther="12")), {"time_s": [0, 0.004, 0.008], "nearer": [1, 2, 3], "farther": [5, 6, 7]})

    def test_half_hours_of_a_country(self):
        content = b"datetime_gmt,solar_gen\n2021-05-01 00:00:00+00:00,0\n2021-05-01 00:30:00+00:00,0.25\n"
        self.assertEqual(told(pickups.half_hours(content)), {"time_s": [0, 1800], "solar": [0, 0.25]})


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Models(unittest.TestCase):
    def test_a_shift_is_found_beside_a_term_either_way(self):
        t = np.arange(0, 20, 0.1)
        x, term, seen = np.sin(t), np.cos(3 * t), np.ones(200, bool)
        for by in (0.3, -0.3):
            y = 2 * np.interp(t - by, t, x) + term + 1
            models = pickups.clocks(y, x, t, 0.5, term=term)
            self.assertLess(np.abs(models["shift, and term"](seen) - y).max(), 1e-6)
            self.assertGreater(np.abs(models["term"](seen) - y).max(), 0.1)


if __name__ == "__main__":
    unittest.main()
