"""Files of the package qats, read from small ones that are made here."""

import unittest

import numpy as np
from tests.made import READS, matlab, told

if READS:
    from readers import qats


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_channels_of_a_basin_are_found_by_their_names(self):
        content = matlab(data=np.array([[5.0, 1, 2], [5.5, 3, 4]]), chan_names=np.array(["Time", "WAVE", "YAW"], object))
        self.assertEqual(told(qats.wave_basin(content, yaw_deg="YAW")), {"time_s": [0, 0.5], "yaw_deg": [2, 4]})

    def test_channels_of_a_towing_tank_are_variables(self):
        content = matlab(Time=np.array([3.0, 3.25]), FX=np.array([7.0, 8]))
        self.assertEqual(told(qats.towing_tank(content, force_n="FX")), {"time_s": [0, 0.25], "force_n": [7, 8]})


if __name__ == "__main__":
    unittest.main()
