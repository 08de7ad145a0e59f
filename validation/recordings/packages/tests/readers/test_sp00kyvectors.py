"""Files of the package sp00kyvectors, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import sp00kyvectors


BOX = (
    b"Timestamp,BME680_Temp,Temp_LSM9DS1,Pressure,Humidity,Color_C\n"
    b"2025-05-06T10:00:01,20,19,1013,50,5\n2025-05-06T10:00:02,22,19,1013,50,7\n2025-05-06T10:01:00,23,20,1013,50,40\n"
    b"2025-05-06T10:02:00,230,20,1013,50,40\n2025-05-01T10:00:00,20,19,1013,50,5\nnonsense,1,1,1,1,1\n"
)


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_box_has_medians_of_minutes_that_are_plausible(self):
        self.assertEqual(told(sp00kyvectors.sensor_box(BOX, "2025-05-0[6-9]", air="BME680_Temp")), {"time_s": [0, 60], "air": [21, 23]})
        self.assertEqual(told(sp00kyvectors.sensor_box(BOX, "2025-05-0[6-9]", least=("Color_C", 20), clear="Color_C")), {"time_s": [0], "clear": [40]})


if __name__ == "__main__":
    unittest.main()
