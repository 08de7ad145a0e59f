"""The list of recordings: what it must say, and that ours says it."""

import hashlib
import importlib.util
import tempfile
import unittest
from pathlib import Path

import sources
from problem import Problem

HASH = hashlib.sha256(b"").hexdigest()
GOOD = f"""
[set.first]
digits = 8
[[archive]]
package = "pack"
version = "1.0"
file = "pack-1.0.tar.gz"
sha256 = "{HASH}"
licence = "MIT"
[[recording]]
name = "one"
set = "first"
archive = "pack-1.0.tar.gz"
inside = ["pack-1.0/rows.txt"]
source = "pack 1.0, rows.txt"
missing = "nothing"
csv_sha256 = "{HASH}"
"""


class Lists(unittest.TestCase):
    def read(self, text):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "sources.toml"
            path.write_text(text)
            return sources.recordings(path)

    def refused(self, text, why):
        with self.assertRaisesRegex(Problem, why):
            self.read(text)

    def test_a_good_list_is_read(self):
        self.assertEqual(self.read(GOOD)["one"].archive.package, "pack")

    def test_what_is_no_toml_is_refused(self):
        self.refused(GOOD + "\n[[recording", "is no TOML")

    def test_a_key_too_few_and_one_too_many_are_named(self):
        self.refused(GOOD.replace('licence = "MIT"', 'license = "MIT"'), "`licence` is missing; `license` is no key here")
        self.refused(GOOD + 'colour = "red"', "`colour` is no key here")

    def test_a_hash_that_is_none_is_refused(self):
        self.refused(GOOD.replace(HASH, HASH[:-1]), "is no SHA-256")

    def test_an_archive_cannot_lie_outside_of_its_folder(self):
        self.refused(GOOD.replace("pack-1.0.tar.gz", "../pack-1.0.tar.gz"), "not the name of a file but a path")

    def test_a_recording_of_an_archive_that_is_not_listed_is_refused(self):
        self.refused(GOOD.replace('archive = "pack', 'archive = "other'), "no \\[\\[archive\\]\\]")

    def test_a_name_that_is_there_twice_is_refused(self):
        self.refused(GOOD + GOOD[GOOD.index("[[recording]]") :], "there twice")

    def test_an_empty_list_is_refused(self):
        self.refused("[set.first]\ndigits = 8", "lists no")

    def test_a_name_that_nothing_has_is_told(self):
        with self.assertRaisesRegex(Problem, "no recording is called two"):
            sources.chosen(self.read(GOOD), ["two"])


class Ours(unittest.TestCase):
    def test_there_are_two_sets(self):
        sets = [one.set for one in sources.recordings().values()]
        self.assertEqual((sets.count("first"), sets.count("second")), (27, 23))

    def test_every_recording_has_a_description_of_its_csv(self):
        for one in sources.recordings().values():
            self.assertIn("[base]", sources.description(one), one.name)

    def test_no_description_and_no_reader_is_left_over(self):
        folder = sources.HERE / "recordings"
        for kind in ("toml", "py"):
            self.assertEqual({path.stem for path in folder.glob(f"*.{kind}")}, set(sources.recordings()))

    @unittest.skipUnless(importlib.util.find_spec("scipy") and importlib.util.find_spec("pandas"), "scipy or pandas is not installed")
    def test_every_reader_names_its_model(self):
        for one in sources.recordings().values():
            if one.name == "glider-optode-temperature" and not importlib.util.find_spec("netCDF4"):
                continue
            self.assertTrue(one.module().HAND_BUILT, one.name)


if __name__ == "__main__":
    unittest.main()
