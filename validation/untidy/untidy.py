"""Diagnoses tables as people have them, each beside a plain twin of the same rows: python untidy.py TRUEGAP [--only WORD] [--write]

Every table goes both ways: `truegap init` and the TOML that it wrote, and `--map` without one. Exit code 1 where an answer is not that of the twin, or a table
that must be refused is not. --write makes answers.csv and the table of README.md again. Needs Python 3.11 and nothing else.
"""
import argparse
import concurrent.futures
import csv
import dataclasses
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

import clean
from tables import Table, all_tables

HERE = pathlib.Path(__file__).parent
#: relative to the spread of a column: a conversion of units and back costs some last digits
SAME_NUMBER = 1e-9
#: of a probability, and of a fitted number relative to its sd: rounding may end a fit at another place
SAME_ANSWER = 0.02
BEGIN, END = "<!-- answers, written by untidy.py -->\n", "<!-- end of answers -->\n"
COLUMNS = ("time_s", "force_n", "temperature_c", "recorded_mv")


@dataclasses.dataclass
class Answer:
    """What came of a table: its diagnosis and the columns that were read, or the text of the refusal."""

    said: str
    diagnosis: dict | None = None
    read: dict[str, list[float]] | None = None

    def words(self) -> str:
        if self.diagnosis is None:
            return "told what to do" if "eft to you: " in self.said else "refused"
        found = " + ".join(finding["effect"] for finding in self.diagnosis["findings"]) or "nothing"
        return f"{self.diagnosis['verdict']}: {found}; {self.diagnosis['recording']['rows']} rows"


class Truegap:
    """The program, in a folder of its own."""

    def __init__(self, program: pathlib.Path, folder: pathlib.Path) -> None:
        self.program, self.folder = program, folder

    def run(self, *arguments: str, stream: bytes | None = None) -> tuple[int, str, str]:
        done = subprocess.run([self.program, *arguments], cwd=self.folder, input=stream, stdin=None if stream is not None else subprocess.DEVNULL,
                              capture_output=True, timeout=300)
        return done.returncode, done.stdout.decode(), done.stderr.decode()

    def diagnosed(self, *arguments: str, stream: bytes | None = None, said: str = "") -> Answer:
        code, out, err = self.run("--json", "diagnose", *arguments, "--base", "linear", "--library-only", "-o", "out", stream=stream)
        if code > 1:
            return Answer(said + err)
        with (self.folder / "out" / "prediction.csv").open(newline="") as file:
            rows = list(csv.DictReader(file))
        return Answer(said + err, json.loads(out), {name: [float(row[name]) for row in rows] for name in COLUMNS if name in rows[0]})

    def by_init(self, table: Table) -> Answer:
        """`truegap init`, then a diagnosis of what it wrote; where the table came on standard input, of a TOML beside the table as it lies on disk."""
        described = self.folder / table.file.replace(".gz", "")
        described = described.with_suffix(".toml")
        described.unlink(missing_ok=True)
        if table.standard_input:
            code, out, err = self.run("init", "-", stream=table.content)
            described.write_text(out.replace('file = "-"', f'file = "{table.file}"'), encoding="utf-8")
        else:
            code, out, err = self.run("init", table.file)
            written = next((line.removeprefix("Written: ") for line in out.splitlines() if line.startswith("Written: ")), described.name)
            described = self.folder / written
        left = [line for line in (out + err).splitlines() if "eft to you: " in line]
        if code != 0 or any(word in line for word in table.refused for line in left):
            return Answer(out + err)
        answer = self.diagnosed(described.name, *table.told, said=described.read_text(encoding="utf-8"))
        described.unlink()
        return answer

    def by_map(self, table: Table) -> Answer:
        maps = [word for column in table.columns for word in ("--map", column)]
        told = [word for word in table.told if word.startswith("--day")]
        if table.standard_input:
            return self.diagnosed("-", *maps, *told, stream=table.content)
        return self.diagnosed(table.file, *maps, *told)


def diagnosed_twin(program: pathlib.Path, kept: tuple[clean.Row, ...]) -> Answer:
    with tempfile.TemporaryDirectory() as folder:
        clean.write_twin(pathlib.Path(folder) / "twin.csv", list(kept))
        twin = Truegap(program, pathlib.Path(folder)).diagnosed("twin.csv")
    if twin.diagnosis is None or not twin.diagnosis["findings"]:
        sys.exit(f"a twin has no answer: {twin.said}")
    return twin


def diagnosed_both_ways(program: pathlib.Path, table: Table) -> list[Answer]:
    with tempfile.TemporaryDirectory() as folder:
        truegap = Truegap(program, pathlib.Path(folder))
        (truegap.folder / table.file).write_bytes(table.content)
        return [truegap.by_init(table), truegap.by_map(table)]


def wrong(table: Table, came: Answer, twin: Answer) -> str:
    """What is not as it must be; nothing where all is."""
    if table.refused:
        if came.diagnosis is not None:
            return "not refused"
        return "" if any(word in came.said for word in table.refused) else f"refused without {table.refused}: {came.said.strip()[-300:]}"
    if came.diagnosis is None or came.read is None:
        return f"refused: {came.said.strip()[-300:]}"
    if table.note and table.note not in came.said:
        return f"no note with `{table.note}`"
    return read_otherwise(came.read, twin.read) or answers_otherwise(came.diagnosis, twin.diagnosis)


def read_otherwise(came: dict[str, list[float]], twin: dict[str, list[float]]) -> str:
    for name in COLUMNS:
        if name not in came:
            return f"{name} was not read"
        mine, other = came[name], twin[name]
        if len(mine) != len(other):
            return f"{len(mine)} rows, not {len(other)}"
        # a clock may begin anywhere
        if name == "time_s":
            mine, other = [one - mine[0] for one in mine], [one - other[0] for one in other]
        within = SAME_NUMBER * (max(other) - min(other)) + (1e-6 if name == "time_s" else 0.0)
        row = next((at for at, (one, two) in enumerate(zip(mine, other)) if not abs(one - two) <= within), None)
        if row is not None:
            return f"row {row + 1} of {name} is {mine[row]}, not {other[row]}"
    return ""


def answers_otherwise(came: dict, twin: dict) -> str:
    def named(diagnosis: dict) -> list[str]:
        return [finding["effect"] for finding in diagnosis["findings"]]

    if (came["verdict"], named(came)) != (twin["verdict"], named(twin)):
        return f"{came['verdict']} {named(came)}, not {twin['verdict']} {named(twin)}"
    for mine, other in zip(came["findings"], twin["findings"]):
        if abs(mine["probability"] - other["probability"]) > SAME_ANSWER:
            return f"probability of {mine['effect']} is {mine['probability']}, not {other['probability']}"
        for one, two in zip(mine["parameters"], other["parameters"]):
            if not math.isclose(one["value"], two["value"], rel_tol=1e-6, abs_tol=SAME_ANSWER * abs(two["sd"])):
                return f"{one['name']} of {mine['effect']} is {one['value']}, not {two['value']}"
    return ""


def write(header: list[str], lines: list[list[str]]) -> None:
    """The answers as answers.csv, and as the table of the page."""
    with (HERE / "answers.csv").open("w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([header, *lines])
    page = (HERE / "README.md").read_text(encoding="utf-8")
    above, rest = page.split(BEGIN)
    table = "".join(f"| {' | '.join(row)} |\n" for row in [header, ["---"] * len(header), *lines])
    (HERE / "README.md").write_text(f"{above}{BEGIN}{table}{END}{rest.split(END)[1]}", encoding="utf-8")


def main() -> int:
    asked = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    asked.add_argument("program", type=pathlib.Path)
    asked.add_argument("--only", default="", help="tables whose name holds one of these words, A,B")
    asked.add_argument("--write", action="store_true", help="write answers.csv and the table of README.md")
    asked.add_argument("--jobs", type=int, default=os.cpu_count(), help="tables at a time")
    asked = asked.parse_args()
    words = asked.only.split(",")
    tables = [table for table in all_tables() if any(word in table.name for word in words)]
    program = asked.program.resolve()
    lines, failed = [], 0
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        twins = {kept: pool.submit(diagnosed_twin, program, kept) for kept in {table.kept for table in tables}}
        both = [pool.submit(diagnosed_both_ways, program, table) for table in tables]
    for table, answers in zip(tables, both):
        twin, ways = twins[table.kept].result(), list(zip(("init", "--map"), answers.result()))
        faults = {way: wrong(table, came, twin) for way, came in ways}
        wanted = f"refused: {' or '.join(table.refused)}" if table.refused else twin.words()
        lines.append([table.name, table.odd, wanted, *(faults[way] or came.words() for way, came in ways)])
        failed += any(faults.values())
        print(f"{'WRONG' if any(faults.values()) else 'ok':6}{table.name}: {wanted}")
        for way, fault in faults.items():
            if fault:
                print(f"      {way}: {fault}")
    print(f"{len(tables)} tables, {failed} wrong")
    if asked.write:
        write(["table", "what is odd", "wanted", "by `truegap init`", "by `--map`"], lines)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
