"""How usual names are beforehand: the table of the program is that of the right names that were written down."""

import sys
import tempfile
import unittest
from pathlib import Path

import table

VALIDATION = Path(__file__).resolve().parents[3]
sys.path.append(str(VALIDATION / "stated"))
import usual  # noqa: E402

TABLE = VALIDATION.parent / "crates" / "truegap-diagnose" / "tables" / "usual_names.csv"


class Usual(unittest.TestCase):
    def test_the_table_of_the_program_is_made_from_the_sets(self):
        with tempfile.TemporaryDirectory() as folder:
            made = Path(folder) / "usual_names.csv"
            table.put(made, usual.HEADER, usual.counted())
            self.assertEqual(made.read_text(encoding="utf-8"), TABLE.read_text(encoding="utf-8"))

    def test_a_recording_could_show_what_it_has_columns_for(self):
        linear = {"columns": {"response": "y"}, "drivers": {"load": {}, "warmth": {}}, "base": {"model": "linear"}}
        self.assertEqual(usual.could_show(linear), {"driver", "input"})
        beside_a_simulation = {"columns": {"time": "t", "simulated": "x", "temperature": "w"}, "base": {"model": "external"}}
        self.assertEqual(usual.could_show(beside_a_simulation), {"clock", "temperature", "input"})
