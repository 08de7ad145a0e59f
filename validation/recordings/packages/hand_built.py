#!/usr/bin/env python3
"""Fits the models built by hand, and tells their errors on the rows that truegap left out.

    python3 hand_built.py RECORDINGS ANSWERS [NAME...]

RECORDINGS is a folder that fetch.py has written, ANSWERS one of bench.py: which rows were used and which were left out together is taken from there. The model with
a star is the one of the table. A model sees the columns of the CSV and nothing else.
"""

import argparse
from pathlib import Path

import held_out
import sources
import table
from problem import Problem, command


def scores(recording, folder, answers):
    """Errors in sample and held out of every model of a recording, by name; the first is the base model."""
    columns = table.read(Path(folder) / recording.name / f"{recording.name}.csv")
    y, models = recording.module().models(columns)
    found = held_out.answer(Path(answers) / recording.name)
    rows, runs = held_out.used_rows(y, Path(answers) / recording.name)
    left_out = held_out.parts(found, runs, held_out.judged_rows(Path(answers) / recording.name))
    return {name: held_out.errors(y, model, rows, left_out) for name, model in models.items()}


def figure(recording, folder, answers):
    """The held-out error of the model of the table."""
    return scores(recording, folder, answers)[recording.module().HAND_BUILT][1]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("recordings", metavar="RECORDINGS")
    parser.add_argument("answers", metavar="ANSWERS")
    parser.add_argument("names", metavar="NAME", nargs="*")
    given = parser.parse_intermixed_args()
    failed = 0
    for recording in sources.chosen(sources.recordings(), given.names):
        try:
            told = scores(recording, given.recordings, given.answers)
        except Problem as problem:
            print(f"{recording.name}: {problem}")
            failed += 1
            continue
        of_tool = held_out.answer(Path(given.answers) / recording.name)["fit"]["held_out"]
        print(f"{recording.name}: truegap held out, base model {of_tool['rmse_before']:.4g}, its answer {of_tool['rmse_after']:.4g}")
        for name, (in_sample, left_out) in told.items():
            star = "*" if name == recording.module().HAND_BUILT else " "
            print(f"  {star} {name}: in sample {in_sample:.4g}, held out {left_out:.4g}")
    return 2 if failed else 0


if __name__ == "__main__":
    command(main)
