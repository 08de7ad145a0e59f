"""Pickles: what is read and what is refused."""

import pickle
import unittest

from problem import Problem

from tests.made import READS

if READS:
    from formats import pickled


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Pickles(unittest.TestCase):
    def test_bytes_of_an_old_protocol_are_read(self):
        self.assertEqual(pickled.plain(pickle.dumps(b"\xff\x01", protocol=2)), b"\xff\x01")

    def test_another_encoding_is_refused(self):
        asked = b"c_codecs\nencode\n(X\x01\x00\x00\x00aX\x05\x00\x00\x00rot13tR."
        with self.assertRaisesRegex(Problem, "the encoding `rot13`"):
            pickled.plain(asked)

    def test_what_no_table_needs_is_refused(self):
        with self.assertRaisesRegex(Problem, "`posix.system`"):
            pickled.plain(b"cposix\nsystem\n(X\x02\x00\x00\x00lstR.")


if __name__ == "__main__":
    unittest.main()
