"""Files of the package ppms-toolkit, read from small ones that are made here."""

import unittest

from tests.made import READS

if READS:
    from readers import ppms_toolkit


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_a_magnetometer_is_read_where_it_has_measured(self):
        content = b"[Header]\nx\n[Data]\nComment,Moment (emu)\n,\n,2\n,3\n,4\n"
        self.assertEqual(ppms_toolkit.moments(content, 2)["Moment (emu)"].tolist(), [2, 4])


if __name__ == "__main__":
    unittest.main()
