#!/usr/bin/env python3
"""Counts the names of answers against the right names that were written down before the first run.

    python3 names.py ANSWERS [--table FILE]

ANSWERS holds one folder a recording, as bench.py writes them. A cause is found where a finding, or one of those that the answer cannot tell from it, is among its right names. Exit codes: 0
every recording of a set that was written down has an answer, 2 one has none.
"""

import argparse
import csv
import json
import sys
from pathlib import Path

import sources
import table
from problem import Problem, command

SETS = ("third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth", "eleventh", "twelfth", "thirteenth", "fourteenth", "fifteenth", "sixteenth", "seventeenth", "eighteenth", "nineteenth", "twentieth", "twenty-first", "twenty-second", "twenty-third", "twenty-fourth", "twenty-fifth", "twenty-sixth", "twenty-seventh", "twenty-eighth", "twenty-ninth", "thirtieth", "thirty-first", "thirty-second")
KINDS = ("right", "near", "wrong", "missed", "false")
HEADER = ["set", "recordings", "right, or in a set that holds it", "some names too many or too few", "wrong", "nothing named", "named where nothing is missing"]


def right_names(of):
    """Causes of each recording of a set, each with the names that would be right."""
    with open(sources.HERE / of / "expected.csv", newline="", encoding="utf-8") as file:
        return {line["recording"]: [cause.split("|") for cause in line["right names"].split(";")] for line in csv.DictReader(file)}


# effects that came to the library after a set was written down, and what they were called in it: a loop that saturates is a loop and a saturation, a logarithm of the time is a law of a drift
CAME_LATER = {"saturating_loop": ["friction", "saturation"], "settling": ["offset_drift"]}


def names_told(found):
    """One set of names for each cause that an answer tells, in the words of the sets."""
    rivals = {names[0]: names for names in found["ambiguity"]}
    for finding in found["findings"]:
        own, *others = rivals.get(finding["effect"], [finding["effect"]])
        others = [old for name in others for old in [name, *CAME_LATER.get(name, [])]]
        yield from ({own, old, *others} for old in CAME_LATER.get(own, [own]))


def judged(found, causes):
    """One of KINDS: what an answer says against the causes."""
    told = list(names_told(found))
    nothing_is_right = any("agrees" in names for names in causes)
    missing = [set(names) - {"agrees"} for names in causes if set(names) != {"agrees"}]
    if not told:
        return "right" if nothing_is_right and found["verdict"] == "agrees" else "missed"
    if not missing:
        return "false"
    caught = sum(any(names & right for names in told) for right in missing)
    extra = sum(not any(names & right for right in missing) for names in told)
    if caught == len(missing) and not extra:
        return "right"
    return "near" if caught else "wrong"


def answer(answers, name):
    path = Path(answers) / name / "diagnosis.json"
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise Problem(f"{path} cannot be read: {error}; diagnose {name} first (bench.py)") from error


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("answers", metavar="ANSWERS")
    parser.add_argument("--table", metavar="FILE", help="where the CSV is written")
    given = parser.parse_args(arguments)
    rows = []
    for of in SETS:
        kinds = {name: judged(answer(given.answers, name), causes) for name, causes in right_names(of).items()}
        for name, kind in kinds.items():
            print(f"{of}: {name}: {kind}", file=sys.stderr)
        rows.append([of, len(kinds), *(sum(found == kind for found in kinds.values()) for kind in KINDS)])
    table.put(given.table, HEADER, rows)
    return 0


if __name__ == "__main__":
    command(main)
