"""From answers to the table: rows left out, errors of models built by hand, and answers that are not there."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import bench
import held_out
import sources
from problem import Problem


def found(how, names):
    return {"fit": {"held_out": {"how": how, "parts": [[name, 1.0, 1.0] for name in names]}}}


class Parts(unittest.TestCase):
    def test_blocks_are_those_of_the_tool(self):
        how = "6 blocks of the one run, each left out in turn"
        blocks = held_out.parts(found(how, [f"block {k}" for k in range(1, 7)]), np.ones(20, int))
        # the borders k n / 6, rounded down
        self.assertEqual([(b[0], b[-1]) for b in blocks], [(0, 2), (3, 5), (6, 9), (10, 12), (13, 15), (16, 19)])

    def test_runs_are_left_out_as_they_were_named(self):
        (positions,) = held_out.parts(found("each run left out in turn", ["run 1, 11"]), np.array([1, 1, 2, 11]))
        self.assertEqual(positions.tolist(), [0, 1, 3])

    def test_only_parts_that_the_tool_predicted_count(self):
        blocks = held_out.parts(found("2 blocks of the one run", ["block 2"]), np.ones(4, int))
        self.assertEqual([b.tolist() for b in blocks], [[2, 3]])

    def test_a_part_of_another_kind_is_refused(self):
        with self.assertRaisesRegex(Problem, "neither a block nor runs"):
            held_out.parts(found("each recording in turn", ["recording a"]), np.ones(4, int))

    def test_an_answer_without_rows_left_out_is_refused(self):
        with self.assertRaisesRegex(Problem, "no rows left out"):
            held_out.parts({"fit": {"held_out": None}}, np.ones(4, int))


class Rows(unittest.TestCase):
    def used(self, response, text):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "prediction.csv").write_text(text)
            return held_out.used_rows(np.array(response), folder)

    def test_rows_that_the_tool_left_away_are_skipped(self):
        rows, runs = self.used([1.0, 5.0, 2.0, 2.0, 3.0], "run,recorded_v\n1,1\n1,2\n2,2\n2,3\n")
        self.assertEqual((rows.tolist(), runs.tolist()), ([0, 2, 3, 4], [1, 1, 2, 2]))

    def test_rows_over_which_the_tool_takes_no_error_are_in_no_part(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "prediction.csv").write_text("run,base_held_out_v\n1,1\n1,2\n1,3\n1,\n")
            judged = held_out.judged_rows(folder)
        blocks = held_out.parts(found("2 blocks of the one run", ["block 1", "block 2"]), np.ones(4, int), judged)
        self.assertEqual([b.tolist() for b in blocks], [[0, 1], [2]])

    def test_an_answer_to_another_recording_is_refused(self):
        with self.assertRaisesRegex(Problem, "no row for its row 2, 9"):
            self.used([1.0, 2.0], "run,recorded_v\n1,1\n1,9\n")


class Errors(unittest.TestCase):
    def test_a_mean_is_taken_of_the_other_rows_and_rows_left_away_never_count(self):
        y = np.array([0.0, 2.0, 100.0, 4.0, 6.0])
        mean = lambda seen: np.full(len(y), y[seen].mean())
        inside, outside = held_out.errors(y, mean, np.array([0, 1, 3, 4]), [np.array([0, 1]), np.array([2, 3])])
        # by hand: mean 3 of four rows; mean 5 for rows 0 and 2, mean 1 for 4 and 6
        self.assertAlmostEqual(inside, np.sqrt((9 + 1 + 1 + 9) / 4))
        self.assertAlmostEqual(outside, np.sqrt((25 + 9 + 9 + 25) / 4))


class Verdicts(unittest.TestCase):
    def test_names_that_cannot_be_told_apart_stand_together(self):
        findings = [{"effect": "nonlinearity"}, {"effect": "discovered"}, {"effect": "friction"}]
        told = bench.verdict({"verdict": "ambiguous", "findings": findings, "ambiguity": [["friction", "a", "b", "c"]]})
        self.assertEqual(told, "ambiguous: nonlinearity; a composed mechanism; friction or a or b or others")

    def test_a_verdict_without_names_stands_alone(self):
        self.assertEqual(bench.verdict({"verdict": "agrees", "findings": [], "ambiguity": []}), "agrees")

    def test_who_is_near_the_model_built_by_hand_is_counted_by_set(self):
        def row(of, by_hand, before, now):
            cells = dict.fromkeys(bench.HEADER, "")
            return list((cells | {"set": of, "hand-built, held out": by_hand, "held out before": before, "held out": now}).values())

        rows = [row("first", "1.0", "1.2", "1.1"), row("first", "2", "2.0", "0.5"), row("second", "1", "", "1.2")]
        self.assertEqual(list(bench.summary(rows)), [("first", 2, 1, 2), ("second", 1, 0, 0)])

    def test_every_recording_has_an_answer_from_before_unless_its_set_was_never_run(self):
        known, answered = sources.recordings(), set(bench.answers_before())
        self.assertLessEqual(answered, set(known))
        run = {known[name].set for name in answered}
        self.assertEqual(answered, {name for name, one in known.items() if one.set in run})
        self.assertLessEqual({"first", "second", "third"}, run)


class Command(unittest.TestCase):
    def test_an_answer_to_other_rows_gets_no_row(self):
        recording = next(iter(sources.recordings().values()))
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / recording.name / f"{recording.name}.csv"
            path.parent.mkdir()
            path.write_text("x,y\n1,2\n")
            with self.assertRaisesRegex(Problem, "is not the recording"):
                bench.row(recording, folder, folder, {})

    def test_a_tool_that_fails_leaves_no_older_answer_and_no_table(self):
        name = next(iter(sources.recordings()))
        with tempfile.TemporaryDirectory() as folder:
            answer = Path(folder) / "answers" / name / "diagnosis.json"
            answer.parent.mkdir(parents=True)
            answer.write_text(json.dumps({"verdict": "agrees"}))
            tool = f"""{sys.executable} -c 'import sys; print("out of order", file=sys.stderr); sys.exit(2)'"""
            run = [sys.executable, str(sources.HERE / "bench.py"), folder, f"{folder}/answers", name, "--truegap", tool, "--table", f"{folder}/t.csv"]
            done = subprocess.run(run, capture_output=True, text=True)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("exit code 2: out of order", done.stderr)
            self.assertEqual((answer.exists(), Path(folder, "t.csv").exists()), (False, False))


if __name__ == "__main__":
    unittest.main()
