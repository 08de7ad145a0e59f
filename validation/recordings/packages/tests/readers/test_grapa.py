"""Files of the package grapa, read from small ones that are made here."""

import unittest

from tests.made import READS, told

if READS:
    from readers import grapa


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_ions_are_found_by_the_head_two_lines_above_the_table(self):
        content = b"\ttotal\tGa+\t^71Ga+\n\t\t68.9\t70.9\nSputter Time (s)\tIntensity\tIntensity\tIntensity\n4.0\t1\t2\t3\t\n6.0\t4\t5\t6\t\n8.0\t7\t8\t9\t\n"
        self.assertEqual([list(values) for values in grapa.sputtered_ions(content, "", "^71Ga+", "Ga+")], [[6, 8], [6, 9], [5, 8]])

    def test_each_file_of_a_cell_is_a_run(self):
        file = lambda *rows: ("\ufeffSample name: \tS\nFrequency [Hz]\tC [nF]\tTemperature [K]\tRp [Ohm]\n\n" + "\n".join(rows) + "\n").encode()
        read = grapa.capacitances(file("100\t5\t123.1\t9", "1000\t4\t123.2\t9"), file("10\t6\t133\t9"))
        self.assertEqual(told(read), {"run": [1, 1, 2], "decades": [2, 3, 1], "cell_k": [123.1, 123.2, 133], "capacitance_nf": [5, 4, 6]})

    def test_a_cell_that_is_kept_hot_is_left_out_while_it_has_less_light(self):
        content = 'a\nb\nc\n"Measurement No";"Time";"Pmp [mW/cm^2]";"Illumination"\n1;00:00:00:00;5;5.8\n2;00:00:30:01;0;0.1\n3;01:02:00:05;4;5.8\n'.encode()
        self.assertEqual(told(grapa.cell_kept_hot(content, least=5)), {"time_s": [0, 93605], "power_mw_cm2": [5, 4]})


if __name__ == "__main__":
    unittest.main()
