#!/usr/bin/env python3
"""Both lists of planted errors against today's sources: every text that an error replaces stands exactly once in the file it names, and the test that is to
notice it stands in its crate; and a copy is not taken for another one.

    python3 validation/mutants/test_patterns.py

Nothing is built. A pattern that no longer fits would end the run that plants it, and that run is not made with every change.
"""

import importlib
import os
import re
import sys
import tempfile
import time
import tomllib
import unittest
from pathlib import Path
from unittest import mock

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path += [str(HERE), str(ROOT / "validation/verification")]
TOOLS = [importlib.import_module(name) for name in ("mutants", "mutations")]
PLACE = re.compile(r"(?s)(.*)«(.*)»(.*)")


def mutants():
    """Name, file, text that must stand there once and what is put in its place, of `mutants.toml`."""
    for m in tomllib.loads((HERE / "mutants.toml").read_text())["mutant"]:
        before, right, after = PLACE.fullmatch(m["at"]).groups()
        yield m["name"], ROOT / "crates" / m["crate"] / "src" / m["file"], before + right + after, before + m["to"] + after


def mutations():
    """The same of the finite elements' list."""
    for m in tomllib.loads((ROOT / "validation/verification/mutations.toml").read_text())["mutation"]:
        yield m["name"], ROOT / "crates/truegap-fem/src" / m["file"], m["from"], m["to"]


def tests():
    """Name, crate and test of `mutants.toml`."""
    for m in tomllib.loads((HERE / "mutants.toml").read_text())["mutant"]:
        yield m["name"], m["crate"], m["test"]


def words(crate):
    """What the modules of a crate are called, and its functions."""
    files = list((ROOT / "crates" / crate).rglob("*.rs"))
    text = "\n".join(file.read_text() for file in files)
    modules = {file.stem for file in files} | {file.parent.name for file in files} | set(re.findall(r"\bmod (\w+)", text))
    return modules, re.findall(r"\bfn (\w+)", text)


class Patterns(unittest.TestCase):
    def test_every_test_that_is_to_notice_an_error_stands_in_its_crate(self):
        known = {crate: words(crate) for crate in {crate for _, crate, _ in tests()}}
        for name, crate, test in tests():
            (*inside, last), (modules, functions) = test.split("::"), known[crate]
            with self.subTest(name):
                self.assertLessEqual(set(inside), modules, test)
                self.assertTrue(last in modules or any(last in function for function in functions), test)

    def test_every_pattern_stands_once(self):
        for name, file, whole, _ in [*mutants(), *mutations()]:
            with self.subTest(name):
                self.assertEqual(file.read_text().count(whole), 1, f"`{whole}` in {file.relative_to(ROOT)}")

    def test_every_error_changes_something_and_has_a_name_of_its_own(self):
        for entries in [list(mutants()), list(mutations())]:
            self.assertEqual(len({name for name, *_ in entries}), len(entries))
            for name, _, right, wrong in entries:
                self.assertNotEqual(right, wrong, name)

    def test_the_pages_count_what_the_lists_hold(self):
        mutants_page = (HERE / "README.md").read_text()
        mutations_page = (ROOT / "validation/verification/mutations.md").read_text()
        results = (ROOT / "docs/results.md").read_text()
        told = re.search(r"\*\*\d+ of (\d+) killed\*\*[^.]*\.(?: (\d+) more of the list were not run yet\.)?", mutants_page)
        self.assertEqual(int(told.group(1)) + int(told.group(2) or 0), len(list(mutants())))
        told = re.search(r"^(\d+ of (\d+)) killed\.(?: (\d+) more of the list were not run yet\.)?", mutations_page, flags=re.MULTILINE)
        self.assertEqual(int(told.group(2)) + int(told.group(3) or 0), len(list(mutations())))
        self.assertIn(f"{told.group(1)} planted errors are noticed", results)
        if told.group(3):
            self.assertIn(f"{told.group(3)} more wait for their run", results)


class Copies(unittest.TestCase):
    """A program that was built of another copy was run where both had one target folder: its tests did not know the errors of this copy."""

    def test_every_copy_has_a_target_folder_of_its_own(self):
        with tempfile.TemporaryDirectory() as shared, tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as other:
            with mock.patch.dict(os.environ, {"CARGO_TARGET_DIR": shared}):
                for tool in TOOLS:
                    folders = [Path(tool.building(Path(scratch))["CARGO_TARGET_DIR"]) for scratch in (one, other)]
                    self.assertEqual(folders, [Path(one).resolve() / "target", Path(other).resolve() / "target"])

    def test_no_file_of_a_copy_is_older_than_the_copy(self):
        for tool in TOOLS:
            with tempfile.TemporaryDirectory() as scratch:
                begin = time.time() - 1.0  # s; a file system may count whole seconds
                tool.copy(Path(scratch))
                old = [file for file in Path(scratch).rglob("*.rs") if file.stat().st_mtime < begin]
                self.assertEqual(old, [])


if __name__ == "__main__":
    unittest.main()
