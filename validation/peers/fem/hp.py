#!/usr/bin/env python3
"""truegap's hp version beside the best of the other programs on meshes that are graded for the singularity, in pairs.

    cargo build -p truegap-fem --example beside_peers
    python3 validation/peers/fem/hp.py [--repeats 5]

For every problem and error asked the other programs get the smallest graded mesh of `peers.csv` on which each met the error there, and
the fastest of them there takes part, with every other one that `--all` asks for. truegap starts from the drawing: meshing, all spaces
and all estimates count. The programs take turns; every turn gives a ratio, and the median of the ratios is printed beside the least
seconds. Seconds are processor seconds as in `fem.py`. Writes `validation/verification/hp.csv` and `hp.md`.
"""

import argparse
import csv
import json
import os
import statistics
import subprocess
import sys
from pathlib import Path

import fem
from tables import EXACT, NAMES

FOLDER = fem.ROOT / "validation/verification"
OWN = {"hp": "truegap, hp version", "refine": "truegap, refinement of quadratic elements"}
COMMANDS = {"hp": "hp", "refine": "adapt"}
FIELDS = ["problem", "asked", "turn", "program", "unknowns", "seconds", "value"]


def main():
    options = arguments()
    environment = dict(os.environ, PYTHONPATH=str(fem.HERE))
    for name in ["RAYON_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS"]:
        environment[name] = "1"
    options.tables, options.problems, options.threads, options.csv = "none", "none", 1, FOLDER / "none.csv"
    bench = fem.Bench(options, environment)
    rows = []
    for problem in ["open", "rubber"]:
        for asked in ["1e-4", "1e-6"]:
            rows += compare(bench, problem, asked, options)
    with open(FOLDER / "hp.csv", "w", newline="") as out:
        writer = csv.DictWriter(out, FIELDS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    (FOLDER / "hp.md").write_text(page(rows))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--venv", type=Path, default=fem.ROOT / "target/peers-venv")
    parser.add_argument("--scratch", type=Path, default=fem.ROOT / "target/peers")
    parser.add_argument("--truegap", type=Path, default=fem.ROOT / "target/debug/examples/beside_peers")
    return parser.parse_args()


def sizes(problem, asked, peers):
    """The smallest graded mesh on which each program met the error, fastest program first: (seconds there, program, size)."""
    with open(FOLDER / "peers.csv") as file:
        rows = [r for r in csv.DictReader(file) if r["table"] == "accuracy" and r["problem"] == problem and r["mesh"] == "graded"]
    met = [r for r in rows if r["program"] in peers and abs(float(r["value"]) / EXACT[problem] - 1) <= float(asked)]
    best = {}
    for r in sorted(met, key=lambda r: float(r["seconds"])):
        best.setdefault(r["program"], (float(r["seconds"]), r["program"], int(r["asked"])))
    return sorted(best.values())


def compare(bench, problem, asked, options):
    """All turns of one problem and error."""
    drawing = "disc" if problem == "open" else problem
    others = sizes(problem, asked, bench.peers)
    others = others if options.all else others[:2]
    rows = []
    for turn in range(options.repeats):
        for key, program in OWN.items():
            command = [options.truegap, COMMANDS[key], drawing, asked]
            found = subprocess.run(command, capture_output=True, text=True, env=bench.environment, check=True)
            rows.append(row(problem, asked, turn, program, json.loads(found.stdout)))
        for _, program, size in others:
            found = bench.run(program, problem, bench.mesh(problem, "graded", size))
            if found is not None:
                rows.append(row(problem, asked, turn, program, found))
    return rows


def row(problem, asked, turn, program, found):
    known = {"problem": problem, "asked": asked, "turn": turn, "program": program, "unknowns": int(found["unknowns"])}
    out = {**known, "seconds": found["seconds"], "value": found["value"]}
    print(out, file=sys.stderr)
    return out


def page(rows):
    """The table, from the rows alone."""
    behind = []
    lines = [HEAD.format(turns=len({r["turn"] for r in rows}))]
    for problem in dict.fromkeys(r["problem"] for r in rows):
        lines += [f"\n## {NAMES[problem]}\n", "| error asked | program | unknowns | least seconds | of the hp version's, median of the turns (range) | error |", "|---|---|---|---|---|---|"]
        for asked in dict.fromkeys(r["asked"] for r in rows if r["problem"] == problem):
            group = [r for r in rows if r["problem"] == problem and r["asked"] == asked]
            own = {r["turn"]: r["seconds"] for r in group if r["program"] == OWN["hp"]}
            for program in dict.fromkeys(r["program"] for r in group):
                turns = [r for r in group if r["program"] == program]
                ratios = [r["seconds"] / own[r["turn"]] for r in turns]
                spread = "1" if program == OWN["hp"] else f"{statistics.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f})"
                error = abs(turns[0]["value"] / EXACT[problem] - 1)
                if min(ratios) < 1:
                    behind.append(f"{NAMES[problem]} at {asked}: {program}")
                lines.append(f"| {asked} | {program} | {turns[0]['unknowns']} | {min(r['seconds'] for r in turns):.4f} | {spread} | {error:.1e} |")
    where = f"; where it is not in every turn: {'; '.join(behind)}" if behind else ", here in every turn"
    return "\n".join([*lines, TAIL.format(behind=where)])


HEAD = """# The hp version beside other programs on graded meshes

truegap starts from the drawing and goes on until its own estimate is below the error asked: seconds include meshing, all spaces and all estimates. The others
get a mesh that is already graded for the singularity, solve once, and estimate nothing; it is the smallest one on which they met the error in
[peers.md](peers.md). Processor seconds, one thread, {turns} turns, the programs one after the other in each turn."""

TAIL = """
Above 1 the hp version is ahead{behind}. A case file asks for the hp version by `method = "hp"` ([cases.md](../../docs/cases.md#two-methods)), Rust by `solve_hp`.

Made by `python3 validation/peers/fem/hp.py`.
"""

if __name__ == "__main__":
    main()
