"""Files of the package materialdatabase, read from small ones that are made here."""

import json
import unittest

from tests.made import READS, told

if READS:
    from readers import materialdatabase


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_each_warmth_and_frequency_of_a_ferrite_is_a_run(self):
        rows = [{"temperature": 30, "frequency": 100000, "flux_density": [0, 0.1], "mu_phi_deg": [1, 2]}, {"temperature": 30, "frequency": 200000, "flux_density": [0.2], "mu_phi_deg": [3]}]
        content = json.dumps({"N49": {"measurements": {"complex_permeability": {"LEA_LK": {"measurement_data": rows}}}}}).encode()
        self.assertEqual(told(materialdatabase.ferrite(content, "N49", 0.01)), {"run": [1, 2], "frequency_khz": [100, 200], "flux_t": [0.1, 0.2], "angle_deg": [2, 3]})


if __name__ == "__main__":
    unittest.main()
