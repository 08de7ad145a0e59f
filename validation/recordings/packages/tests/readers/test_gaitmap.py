"""Files of the package gaitmap, read from small ones that are made here."""

import unittest

import numpy as np
from tests.made import READS, told

if READS:
    from readers import gaitmap


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_foot_pitches_by_heel_and_toe(self):
        heights = np.tan(np.radians([0, 1, 2, 3]))
        rows = "\n".join(f"{k},10,0,{heights[k]},9,0,0" for k in range(4))
        markers = f",L_TOE,L_TOE,L_TOE,L_FCC,L_FCC,L_FCC\n,x,y,z,x,y,z\n{rows}\n"
        sensors = "sensor,left_sensor,left_sensor\naxis,gyr_y,gyr_z\n" + "\n".join(f"{k},{k},{-k}" for k in range(9)) + "\n"
        read = told(gaitmap.foot_pitch(markers.encode(), sensors.encode(), "left"))
        self.assertEqual(read["markers"], [-100, -100, -100, -100])
        self.assertEqual((read["gyro"], read["twist"]), ([0, 2.048, 4.096, 6.144], [0, -2.048, -4.096, -6.144]))


if __name__ == "__main__":
    unittest.main()
