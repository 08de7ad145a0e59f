"""The sets that are blind: what was written down before their first run names every recording, and models built by hand are left rows as truegap leaves them."""

import csv
import unittest

import numpy as np

import models_before
import names
import sources


class WrittenDownBefore(unittest.TestCase):
    def names(self, of):
        return {name for name, one in sources.recordings().items() if one.set == of}

    def test_every_recording_has_right_names(self):
        for of in names.SETS:
            with open(sources.HERE / of / "expected.csv", newline="", encoding="utf-8") as file:
                lines = list(csv.DictReader(file))
            self.assertEqual({line["recording"] for line in lines}, self.names(of))

    def test_names_are_effects_of_the_library_or_agrees(self):
        library = (sources.HERE.parents[2] / "docs" / "effects.md").read_text(encoding="utf-8")
        for of in names.SETS[1:]:
            with open(sources.HERE / of / "expected.csv", newline="", encoding="utf-8") as file:
                lines = list(csv.DictReader(file))
            for line in lines:
                for cause in line["right names"].split(";"):
                    for name in cause.split("|"):
                        self.assertTrue(name == "agrees" or f"\n## {name}\n" in library, f"{line['recording']}: {name}")

    def test_every_recording_has_its_models_and_one_star(self):
        for of in names.SETS:
            text = (sources.HERE / of / "models-before.txt").read_text(encoding="utf-8")
            parts = [part for part in ("\n" + text).split("\n") if part]
            heads = [part.split()[0] for part in parts if not part.startswith(" ")]
            self.assertEqual(set(heads), self.names(of))
            self.assertEqual(sum(part.startswith("   * ") for part in parts), len(heads))


class RowsLeftOut(unittest.TestCase):
    def test_one_run_is_left_out_in_six_blocks(self):
        parts = models_before.left_out({"y": np.zeros(20)}, {})
        self.assertEqual([(part[0], part[-1]) for part in parts], [(0, 2), (3, 5), (6, 9), (10, 12), (13, 15), (16, 19)])

    def test_runs_are_left_out_in_turn_by_the_column_that_the_description_names(self):
        parts = models_before.left_out({"dive": np.array([1, 1, 2, 11]), "y": np.zeros(4)}, {"columns": {"run": "dive"}})
        self.assertEqual([part.tolist() for part in parts], [[0, 1], [2], [3]])

    def test_of_more_than_ten_runs_every_tenth_is_left_out_together(self):
        parts = models_before.left_out({"run": np.arange(1, 13), "y": np.zeros(12)}, {})
        self.assertEqual([part.tolist() for part in parts[:3]], [[0, 10], [1, 11], [2]])
        self.assertEqual(len(parts), 10)
