#!/usr/bin/env python3
"""Diagnoses the fetched recordings and writes the table of docs/real-recordings.md as CSV.

    python3 bench.py RECORDINGS ANSWERS [NAME...] [--truegap COMMAND] [--collect] [--table FILE]

RECORDINGS is a folder that fetch.py has written; ANSWERS gets one folder a recording, as `truegap diagnose -o` writes it. With --collect nothing is diagnosed and the
answers that are there are taken. Without --table the CSV goes to the screen. Exit codes: 0 the table is whole, 2 something is missing and no table was written.
"""

import argparse
import csv
import sys
from pathlib import Path

import archives
import asked
import hand_built
import held_out
import sources
import table
from problem import Problem, command

BEFORE = sources.HERE / "before.csv"
HEADER = ["set", "recording", "from", "known to be missing", "hand-built, held out", "answer before", "held out before"]
HEADER += ["base model, held out", "answer", "held out", "over hand-built", "unit"]
WITHIN = 1.1  # of the model built by hand, to count as near it
SPOKEN = {"discovered": "a composed mechanism", "discovered_second": "a second one"}


def diagnose(recording, folder, answers, truegap):
    """Runs one diagnosis; an older answer is taken away first, so that none can stand in for one that failed."""
    out = Path(answers) / recording.name
    for name in ("diagnosis.json", "prediction.csv"):
        (out / name).unlink(missing_ok=True)
    asked.diagnose(truegap, Path(folder) / recording.name / f"{recording.name}.toml", out)


def verdict(found):
    """Verdict and names of an answer; names that cannot be told apart stand beside each other."""
    rivals = {names[0]: names for names in found["ambiguity"]}

    def told(effect):
        names = rivals.get(effect, [effect])
        return " or ".join(SPOKEN.get(name, name) for name in names[:3]) + (" or others" if len(names) > 3 else "")

    names = "; ".join(told(finding["effect"]) for finding in found["findings"])
    return f"{found['verdict']}: {names}" if names else found["verdict"]


def row(recording, folder, answers, before):
    """The row of one recording."""
    path = Path(folder) / recording.name / f"{recording.name}.csv"
    if archives.sha256(path) != recording.csv_sha256:
        raise Problem(f"{path} is not the recording: its SHA-256 is another; fetch it again")
    found = held_out.answer(Path(answers) / recording.name)
    by_hand = hand_built.figure(recording, folder, answers)
    left_out = found["fit"]["held_out"]
    answer_before, error_before = before.get(recording.name, ("", ""))
    after = left_out["rmse_after"]
    cells = [recording.set, recording.name, recording.source, recording.missing, f"{by_hand:.3g}", answer_before, error_before]
    return [*cells, f"{left_out['rmse_before']:.3g}", verdict(found), f"{after:.3g}", f"{after / by_hand:.2f}", found["fit"]["unit"]]


def answers_before(path=BEFORE):
    """Answer and held-out error of the versions that had not seen a recording, by name."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            return {line["recording"]: (line["answer"], line["held out"]) for line in csv.DictReader(file)}
    except (OSError, KeyError) as error:
        raise Problem(f"{path} cannot be read: {error}") from error


def summary(rows):
    """How many of each set are near the model built by hand, before and now; of the set, as `(set, recordings, before, now)`."""
    by_hand, before, now = (HEADER.index(name) for name in ("hand-built, held out", "held out before", "held out"))
    for name in dict.fromkeys(line[0] for line in rows):
        lines = [line for line in rows if line[0] == name]
        near = [sum(float(line[k] or "inf") <= WITHIN * float(line[by_hand]) for line in lines) for k in (before, now)]
        yield name, len(lines), *near


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("recordings", metavar="RECORDINGS")
    parser.add_argument("answers", metavar="ANSWERS")
    parser.add_argument("names", metavar="NAME", nargs="*")
    parser.add_argument("--truegap", default="truegap", metavar="COMMAND", help="the command (default: truegap)")
    parser.add_argument("--collect", action="store_true", help="diagnose nothing: take the answers that are there")
    parser.add_argument("--table", metavar="FILE", help="where the CSV is written")
    given = parser.parse_intermixed_args(arguments)
    before, rows, failed = answers_before(), [], 0
    for recording in sources.chosen(sources.recordings(), given.names):
        try:
            if not given.collect:
                diagnose(recording, given.recordings, given.answers, given.truegap)
            rows.append(row(recording, given.recordings, given.answers, before))
            print(f"{recording.name}: {rows[-1][8]}; {rows[-1][10]} of hand-built", file=sys.stderr)
        except Problem as problem:
            print(f"{recording.name}: {problem}", file=sys.stderr)
            failed += 1
    if failed:
        raise Problem(f"{failed} recordings have no row; no table was written")
    for name, count, then, now in summary(rows):
        print(f"{name} set: within {WITHIN} of the model built by hand on rows left out: before {then}, now {now} of {count}", file=sys.stderr)
    table.put(given.table, HEADER, rows)
    return 0


if __name__ == "__main__":
    command(main)
