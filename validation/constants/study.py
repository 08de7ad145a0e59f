#!/usr/bin/env python3
"""What becomes of answers when the constants of constants.toml are halved and doubled.

    python3 validation/constants/study.py check            # the list against the sources
    python3 validation/constants/study.py build            # the instrumented copy, once (minutes)
    python3 validation/constants/study.py compare PLAIN    # with nothing turned, its answers are those of the program PLAIN
    python3 validation/constants/study.py run [ID...]      # every constant that the battery reads; goes on where it stopped
    python3 validation/constants/study.py tables           # constants.csv, most.csv and changed.csv, then: cargo run -p truegap-tables

Nothing of it is in the shipped program. The copy stands in `target/constants`; recordings are found through TRUEGAP_RECORDINGS.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import battery
import inventory
import tables
from instrument import instrumented

FACTORS = {"halved": 0.5, "doubled": 2.0}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["check", "build", "compare", "run", "tables"])
    parser.add_argument("names", nargs="*")
    parser.add_argument("--scratch", type=Path, default=inventory.ROOT / "target/constants")
    parser.add_argument("--program", type=Path, help="the instrumented program, where it was built elsewhere")
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    inventory.check()
    options.scratch.mkdir(parents=True, exist_ok=True)
    program = options.program or options.scratch / "target/release/truegap"
    if options.what == "build":
        build(options.scratch)
    elif options.what == "compare":
        compare(program, Path(options.names[0]), options.scratch)
    elif options.what == "run":
        run(program, options.scratch, options.names, options.jobs)
    elif options.what == "tables":
        tables.write(answers(options.scratch), references(program, options.scratch), FACTORS)
        print("now: cargo run -p truegap-tables")


def build(scratch):
    instrumented(scratch)
    environment = {**os.environ, "CARGO_TARGET_DIR": str(scratch / "target")}
    subprocess.run(["cargo", "build", "--release", "-p", "truegap-cli"], cwd=scratch, env=environment, check=True)


def references(program, scratch):
    """Answer and constants read of every recording with nothing turned; made once."""
    found = {}
    for one in battery.recordings(scratch / "recordings"):
        out = scratch / "unturned" / one["name"]
        text = out / "answer/diagnosis.json"
        if not text.exists():
            out.mkdir(parents=True, exist_ok=True)
            (out / "reads").unlink(missing_ok=True)
            if battery.diagnose(program, one["given"], out / "answer", reads=out / "reads") is None:
                sys.exit(f"{one['name']}: no answer")
        found[one["name"]] = {
            **one,
            "text": text.read_text(),
            "answer": battery.answer(text.read_text()),
            "reads": set((out / "reads").read_text().split()),
        }
    return found


def tells(reference, entry):
    """Whether a recording can tell anything of a constant, and is there for it."""
    return entry["id"] in reference["reads"] and reference.get("only", entry["stage"]) == entry["stage"]


def compare(program, plain, scratch):
    """Ends with the recordings of which the instrumented program says something else."""
    differing = []
    for name, reference in references(program, scratch).items():
        with tempfile.TemporaryDirectory() as out:
            text = battery.diagnose(plain, reference["given"], Path(out))
        same = text is not None and battery.without_seconds(text) == battery.without_seconds(reference["text"])
        print(f"{'same bytes' if same else 'DIFFERENT':10} {name}", flush=True)
        differing += [] if same else [name]
    sys.exit(f"{len(differing)} differ" if differing else 0)


def answers(scratch):
    """What was found so far, by constant, factor and recording."""
    file = scratch / "answers.jsonl"
    rows = [json.loads(line) for line in file.read_text().splitlines()] if file.exists() else []
    return {(row["id"], row["turned"], row["recording"]): row for row in rows}


def run(program, scratch, names, jobs):
    known, unturned = answers(scratch), references(program, scratch)
    tasks = []
    entries = {entry["id"]: entry for entry in inventory.constants()}
    for entry in [entries[name] for name in names] or entries.values():
        for word, factor in FACTORS.items():
            values = inventory.turned(entry, factor)
            for recording, reference in unturned.items():
                key = (entry["id"], word, recording)
                if tells(reference, entry) and key not in known:
                    tasks.append((key, values, reference["given"]))
    seconds = {name: json.loads(reference["text"])["seconds"] for name, reference in unturned.items()}
    tasks.sort(key=lambda task: (unturned[task[0][2]].get("control", False), seconds[task[0][2]]))
    print(f"{len(tasks)} diagnoses", flush=True)

    def one(task):
        (name, word, recording), values, given = task
        with tempfile.TemporaryDirectory() as out:
            turn = f"{name}={','.join(map(repr, values))}"
            found = battery.answer(battery.diagnose(program, given, Path(out), turn))
        row = {"id": name, "turned": word, "recording": recording, "values": values, **found}
        with (scratch / "answers.jsonl").open("a") as file:
            file.write(json.dumps(row) + "\n")

    with ThreadPoolExecutor(jobs) as pool:
        for number, _ in enumerate(pool.map(one, tasks), 1):
            if number % 50 == 0:
                print(f"{number} done", flush=True)


if __name__ == "__main__":
    main()
