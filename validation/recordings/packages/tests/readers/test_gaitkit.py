"""Files of the package gaitkit, read from small ones that are made here."""

import json
import unittest

from tests.made import READS, told

if READS:
    from readers import gaitkit


def frame(knee, height):
    """A frame with one angle and three markers of a foot."""
    places = {f"left_{part}": [1.0, height + k, 2.0] for k, part in enumerate(("ankle", "toe", "heel"))}
    return {"frame_index": 0, "left_knee_angle": knee, "pelvis_tilt": 0.0, "landmark_positions": places}


WALK = json.dumps({"fps": 100.0, "angle_frames": [frame(5.0, 10.0), frame(6.0, 20.0)]}).encode()


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_walk_has_angles_and_markers(self):
        t, angles, markers = gaitkit.walk(WALK)
        self.assertEqual(t.tolist(), [0, 0.01])
        self.assertEqual({name: values.tolist() for name, values in angles.items()}, {"left_knee_angle": [5, 6]})
        self.assertEqual(markers["left_toe"].tolist(), [[1, 11, 2], [1, 21, 2]])

    def test_heights_of_a_foot_are_those_of_one_axis(self):
        self.assertEqual(told(gaitkit.foot(WALK, "left", 1)), {"time_s": [0, 0.01], "ankle_mm": [10, 20], "toe_mm": [11, 21], "heel_mm": [12, 22]})


if __name__ == "__main__":
    unittest.main()
