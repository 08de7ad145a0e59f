"""Files of the package georinex, read from small ones that are made here."""

import gzip
import unittest

from tests.made import READS, told

if READS:
    from readers import georinex as read

HEAD = [
    "     3.03           OBSERVATION DATA    M                   RINEX VERSION / TYPE",
    "E    3 C1C L1C".ljust(60) + "SYS / # / OBS TYPES ",
    "       S1C".ljust(60) + "SYS / # / OBS TYPES ",
    "R    1 S2C".ljust(60) + "SYS / # / OBS TYPES ",
    "".ljust(60) + "END OF HEADER       ",
]


def row(satellite, *values):
    """A row of a satellite; a number that is missing is blank."""
    return satellite + "".join(f"{value:14.3f} 6" if value else " " * 16 for value in values)


ROWS = ["> 2018 07 29 00 00 30.0  0  2", row("E11", 1, 2, 40.5), row("R02", 9), "> 2018 07 29 01 00  0.0  0  1", row("E11", 3, 0, 41), "> 2018 07 29 01 00 15.0  0  1", row("E11", 5, 6, 0)]
FILE = gzip.compress("\n".join([*HEAD, *ROWS]).encode())


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_codes_of_a_system_go_on_in_the_next_line(self):
        self.assertEqual(read.codes(HEAD, "E"), ["C1C", "L1C", "S1C"])
        self.assertEqual(read.codes(HEAD, "R"), ["S2C"])

    def test_rows_in_which_a_wanted_number_is_missing_are_left_out(self):
        self.assertEqual(told(read.observed(FILE, "E11", "S1C", "C1C")), {"time_s": [0, 3570], "S1C": [40.5, 41], "C1C": [1, 3]})
        self.assertEqual(told(read.observed(FILE, "E11", "L1C")), {"time_s": [0, 3585], "L1C": [2, 6]})


if __name__ == "__main__":
    unittest.main()
