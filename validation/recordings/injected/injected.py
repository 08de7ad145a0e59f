#!/usr/bin/env python3
"""Hides known causes in real recordings in which nothing is missing, diagnoses them and counts the names.

    python3 injected.py RECORDINGS WORK [--truegap COMMAND] [--seed N] [--collect] [--table FILE]

RECORDINGS is a folder that ../packages/fetch.py has written; WORK gets one folder a recording and its answer in WORK/answers. A recording that has an answer is not diagnosed again; with --collect nothing is,
and what has no answer yet is told and not counted. Exit codes: 0 counted, 2 bad input.
"""

import argparse
import csv
import re
import sys
import tomllib
from dataclasses import dataclass
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "packages"))
import asked  # noqa: E402
import laws  # noqa: E402
import names  # noqa: E402
import table  # noqa: E402
from problem import Problem, command  # noqa: E402

ANSWERS_TODAY = HERE.parent / "packages.csv"
RATIOS = (1.0, 3.0)  # of what is added and calibration cannot take up, to what the base model leaves: both as RMS
EACH = 3  # kinds hidden in one recording, each in a copy of its own
HEADER = ["hidden", "recordings", "right, or in a set that holds it", "some names too many or too few", "another name", "nothing named"]


@dataclass(frozen=True)
class Case:
    """One recording with one cause hidden in it."""

    of: str
    kind: laws.Kind
    ratio: float

    @property
    def name(self):
        return f"{self.of}--{self.kind.name.replace(' ', '-')}-{self.ratio:.0f}"


def rest():
    """Recordings in which nothing is missing by what was written down before their first run, and by the answer of today."""
    with open(ANSWERS_TODAY, newline="", encoding="utf-8") as file:
        today = {line["recording"]: line["answer"] for line in csv.DictReader(file)}
    for of in names.SETS:
        for name, causes in names.right_names(of).items():
            if any("agrees" in cause for cause in causes) and today.get(name) == "agrees":
                yield name


class Recording:
    """The rows of a fetched recording, its description, and its base model by least squares."""

    def __init__(self, folder, name):
        self.name, path = name, Path(folder) / name / f"{name}.toml"
        try:
            self.text = path.read_text(encoding="utf-8")
            with open(path.with_suffix(".csv"), newline="", encoding="utf-8") as file:
                self.header, *self.cells = list(csv.reader(file))
        except OSError as error:
            raise Problem(f"{path} cannot be read: {error.strerror}; fetch it by ../packages/fetch.py") from error
        said = tomllib.loads(self.text)
        roles, base = said["columns"], said["base"]
        self.response = roles["response"]
        drivers = {driver: entry["column"] for driver, entry in said.get("drivers", {}).items()}
        inputs = [self.column(roles["simulated"])] if base["model"] == "external" else []
        if base["model"] == "linear":
            along = base["driver"]
            inputs = [self.column(drivers.get(along, roles.get(along, along)))]
        self.calibration = np.column_stack([np.ones(len(self.cells)), *inputs])
        reading = self.column(self.response)
        self.known = np.isfinite(self.calibration).all(axis=1) & np.isfinite(reading)
        found, *_ = np.linalg.lstsq(self.calibration[self.known], reading[self.known], rcond=None)
        self.signal = self.calibration @ found
        self.left = np.std((reading - self.signal)[self.known])
        time = self.column(roles["time"]) if "time" in roles else None
        others = [roles["temperature"]] if "temperature" in roles else []
        others += [column for driver, column in drivers.items() if driver != base.get("driver")]
        self.rows = laws.Rows(time, self.signal, self.column(others[0]) if others else None, 0.5)
        self.has = {laws.MOVES} if inputs else set()
        if time is not None and "run" not in roles:
            self.has |= {laws.CLOCK, laws.DAYS} if np.ptp(time) >= 3 * laws.DAY else {laws.CLOCK}
        if self.rows.driver is not None and np.ptp(self.rows.driver[self.known]) > 0:
            self.has.add(laws.OTHER)
        if not np.isfinite(np.column_stack([c for c in (time, self.rows.driver, self.signal) if c is not None])).all():
            self.has -= {laws.CLOCK, laws.OTHER}

    def column(self, name):
        """A column as numbers, NaN where there is none."""
        at = self.header.index(name)
        return np.array([float(row[at]) if row[at].strip() else np.nan for row in self.cells])

    def visible(self, added):
        """RMS of what is added and the calibration cannot take up."""
        off, *_ = np.linalg.lstsq(self.calibration[self.known], added[self.known], rcond=None)
        return np.sqrt(np.mean((added[self.known] - self.calibration[self.known] @ off) ** 2))

    def added(self, kind, ratio, where):
        """What is added so that `ratio` times what the base model leaves is visible; None where the kind cannot do that here."""
        rows = laws.Rows(self.rows.time, self.rows.signal, self.rows.driver, where)
        wanted = ratio * self.left
        unit = np.ptp(rows.time) if laws.CLOCK in kind.needs and not kind.linear else 1.0
        if kind.linear:
            one = self.visible(kind.law(rows, 1.0))
            number = wanted / one if one > 0 else np.inf
            return kind.law(rows, number) if number <= kind.largest else None
        tried = np.geomspace(1e-5, 1.0, 41) * kind.largest * unit
        seen = np.array([self.visible(kind.law(rows, number)) for number in tried])
        if seen.max() < wanted:
            return None
        number = np.interp(wanted, np.maximum.accumulate(seen), tried)
        return kind.law(rows, number)

    def write(self, folder, name, added):
        """The recording with something added to its response, rounded as the response is."""
        at = self.header.index(self.response)
        decimals = max((len(match[1]) for row in self.cells if (match := re.search(r"\.(\d+)$", row[at]))), default=0)
        folder = Path(folder) / name
        folder.mkdir(parents=True, exist_ok=True)
        sums = []
        for row, more in zip(self.cells, added):
            cell = f"{float(row[at]) + more:.{decimals}f}" if row[at].strip() and np.isfinite(more) else row[at]
            sums.append([*row[:at], cell, *row[at + 1 :]])
        table.put(folder / f"{name}.csv", self.header, sums)
        described = re.sub(r'(?m)^file = ".*"$', f'file = "{name}.csv"', self.text)
        described = re.sub(r"(?m)^sha256 = .*\n", "", described)
        (folder / f"{name}.toml").write_text(described, encoding="utf-8")


def cases(recordings, seed):
    """Kinds and sizes drawn for each recording: those that can be hidden in it, the ones that were hidden least so far first."""
    draw, hidden = np.random.default_rng(seed), dict.fromkeys(range(len(laws.KINDS)), 0)
    for name in rest():
        recording = Recording(recordings, name)
        order, sizes, places = draw.permutation(len(laws.KINDS)), draw.choice(RATIOS, len(laws.KINDS)), draw.uniform(0.3, 0.7, len(laws.KINDS))
        found = 0
        for k in sorted(order, key=lambda k: hidden[k]):
            kind = laws.KINDS[k]
            if found == EACH or not kind.needs <= recording.has:
                continue
            added = recording.added(kind, sizes[k], places[k])
            if added is not None:
                found += 1
                hidden[k] += 1
                yield Case(name, kind, sizes[k]), recording, added


def diagnose(work, name, truegap):
    out = Path(work) / "answers" / name
    if (out / "diagnosis.json").exists():
        return
    try:
        asked.diagnose(truegap, Path(work) / name / f"{name}.toml", out)
    except Problem as problem:
        raise Problem(f"{name}: {problem}") from problem


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("recordings", metavar="RECORDINGS")
    parser.add_argument("work", metavar="WORK")
    parser.add_argument("--truegap", default="truegap", metavar="COMMAND", help="the command (default: truegap)")
    parser.add_argument("--seed", type=int, default=1, help="of kinds, sizes and places (default: 1)")
    parser.add_argument("--collect", action="store_true", help="diagnose nothing: count the answers that are there")
    parser.add_argument("--table", metavar="FILE", help="where the CSV is written")
    given = parser.parse_args(arguments)
    counted, unanswered = {}, 0
    for case, recording, added in cases(given.recordings, given.seed):
        if not given.collect:
            recording.write(given.work, case.name, added)
            diagnose(given.work, case.name, given.truegap)
        elif not (Path(given.work) / "answers" / case.name / "diagnosis.json").exists():
            unanswered += 1
            continue
        found = names.answer(Path(given.work) / "answers", case.name)
        judged = names.judged(found, [list(case.kind.right)])
        told = "; ".join(" or ".join(sorted(of)) for of in names.names_told(found))
        print(f"{judged}: {case.name}: {found['verdict']}{': ' if told else ''}{told}", file=sys.stderr)
        for key in (case.kind.name, f"all, {case.ratio:.0f} times what the base model leaves"):
            counted.setdefault(key, []).append(judged)
    if unanswered:
        print(f"{unanswered} have no answer yet and are not counted", file=sys.stderr)
    kinds = [kind.name for kind in laws.KINDS if kind.name in counted]
    keys = kinds + sorted(set(counted) - set(kinds))
    lines = [[key, len(counted[key]), *(counted[key].count(of) for of in ("right", "near", "wrong", "missed"))] for key in keys]
    table.put(given.table, HEADER, lines)
    return 0


if __name__ == "__main__":
    command(main)
