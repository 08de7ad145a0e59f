#!/usr/bin/env python3
"""Both lists of planted errors against today's sources: every text that an error replaces stands exactly once in the file it names.

    python3 validation/mutants/test_patterns.py

Nothing is built. A pattern that no longer fits would end the run that plants it, and that run is not made with every change.
"""

import re
import tomllib
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
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


class Patterns(unittest.TestCase):
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


if __name__ == "__main__":
    unittest.main()
