#!/usr/bin/env python3
"""truegap's finite elements beside scikit-fem, NGSolve and FreeFEM: same problem, same mesh, same elements, same run.

    cargo build -p truegap-fem --example beside_peers
    apt-get install freefem++ libsuitesparse-dev      # the peers that Python's packages do not bring; left out where absent
    python3 validation/peers/fem/fem.py [--sizes 50000,200000,1000000] [--threads 1] [--repeats 3]

Makes a venv (--venv), installs the peers from the package index, lets truegap write the meshes, runs every program on each of them as
a process of its own, and writes `validation/verification/peers.csv`; `tables.py` makes `peers.md` of it, `plots.py` the plots.

What is timed: from the mesh in memory to the number that is asked for - numbering of unknowns, pattern, assembly, elimination of
prescribed values, symbolic and numerical factorisation, solution, evaluation of the result. Not timed: start of the program, imports,
reading the mesh file. Seconds are processor seconds of the process (all threads together), the least of the repeats; with one thread
that is the time on an idle machine, and other work on the machine disturbs it little. Programs take turns, so that a slow minute meets
all of them.
"""

import argparse
import csv
import json
import os
import subprocess
import sys
import venv
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
PACKAGES = ["scikit-fem", "ngsolve", "pypardiso", "scikit-sparse<0.4.17"]
PEERS = {
    "scikit-fem, CHOLMOD": ("run_scikit.py", "cholmod"),
    "scikit-fem, PARDISO": ("run_scikit.py", "pardiso"),
    "NGSolve, sparsecholesky": ("run_ngsolve.py", "sparsecholesky"),
    "FreeFEM, CHOLMOD": ("run_freefem.py", "CHOLMOD"),
}
GRADED = [2_000, 5_000, 10_000, 20_000, 50_000, 100_000]
FIELDS = ["table", "problem", "mesh", "asked", "program", "threads", "unknowns", "seconds", "peak_mb", "value", "levels"]


def main():
    options = arguments()
    environment = dict(os.environ, PYTHONPATH=str(HERE))
    for name in ["RAYON_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS"]:
        environment[name] = str(options.threads)
    bench = Bench(options, environment)
    if "sizes" in options.tables:
        for problem in [p for p in ["disc", "rubber"] if p in options.problems]:
            for size in options.sizes:
                bench.compare("sizes", problem, "graded", size, ["truegap", *bench.peers])
    if "accuracy" in options.tables:
        for problem in [p for p in ["open", "rubber"] if p in options.problems]:
            for target in ["1e-4", "1e-6"]:
                bench.adapt(problem, target)
            for kind, sizes in [("uniform", options.uniform), ("graded", GRADED)]:
                for size in sizes:
                    bench.compare("accuracy", problem, kind, size, bench.peers)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sizes", type=numbers, default=[50_000, 200_000, 1_000_000])
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--tables", default="sizes,accuracy")
    parser.add_argument("--uniform", type=numbers, default=[12_500, 50_000, 200_000, 800_000])
    parser.add_argument("--problems", default="disc,open,rubber")
    parser.add_argument("--venv", type=Path, default=ROOT / "target/peers-venv")
    parser.add_argument("--scratch", type=Path, default=ROOT / "target/peers")
    parser.add_argument("--truegap", type=Path, default=ROOT / "target/debug/examples/beside_peers")
    parser.add_argument("--csv", type=Path, default=ROOT / "validation/verification/peers.csv")
    return parser.parse_args()


def numbers(text):
    return [int(n) for n in text.split(",")]


class Bench:
    """Meshes, runs and rows; a table that is run replaces its rows for the problems asked."""

    def __init__(self, options, environment):
        self.options, self.environment, self.rows, self.meshes = options, environment, [], {}
        options.scratch.mkdir(parents=True, exist_ok=True)
        self.python = install(options.venv)
        self.peers = [name for name in PEERS if self.is_there(name)]
        self.kept = []
        if options.csv.exists():
            with open(options.csv) as old:
                self.kept = [r for r in csv.DictReader(old) if not (r["table"] in options.tables and r["problem"] in options.problems)]

    def is_there(self, name):
        """Whether a peer solves a small problem; says why where it does not."""
        file = self.mesh("rubber", "graded", 1000)
        done = self.run(name, "rubber", file, quiet=True)
        if done is None:
            print(f"left out, does not run here: {name}", file=sys.stderr)
        return done is not None

    def mesh(self, problem, kind, size):
        """Path without ending of a mesh in all formats."""
        drawing = "disc" if problem == "open" else problem
        key = (drawing, kind, size)
        if key not in self.meshes:
            base = self.options.scratch / f"{drawing}-{kind}-{size}"
            msh = f"{base}.msh"
            subprocess.run([self.options.truegap, "mesh", drawing, kind, str(size), msh], check=True)
            subprocess.run([self.python, HERE / "meshes.py", msh, f"{base}"], check=True)
            self.meshes[key] = str(base)
        return self.meshes[key]

    def run(self, program, problem, base, quiet=False):
        """The line that a program prints, or None where it fails."""
        if program == "truegap":
            command = [self.options.truegap, "solve", problem, f"{base}.msh"]
        else:
            script, solver = PEERS[program]
            mesh = f"{base}.ff.msh" if "freefem" in script else f"{base}.npz"
            command = [self.python, HERE / script, solver, problem, mesh]
        done = subprocess.run(command, capture_output=True, text=True, env=self.environment)
        lines = [l for l in done.stdout.splitlines() if l.startswith("{")]
        if done.returncode or not lines:
            if not quiet:
                print(f"{program} failed on {base}: {done.stderr[-500:]}", file=sys.stderr)
            return None
        return json.loads(lines[-1])

    def compare(self, table, problem, kind, size, programs):
        """The least time of each program on one mesh; programs take turns."""
        base = self.mesh(problem, kind, size)
        best = {}
        for _ in range(self.options.repeats):
            for program in programs:
                found = self.run(program, problem, base)
                if found and (program not in best or found["seconds"] < best[program]["seconds"]):
                    best[program] = found
        for program, found in best.items():
            self.add(table, problem, kind, size, program, found)

    def adapt(self, problem, target):
        """truegap's own refinement to a relative error."""
        drawing = "disc" if problem == "open" else problem
        command = [self.options.truegap, "adapt", drawing, target]
        runs = [subprocess.run(command, capture_output=True, text=True, env=self.environment, check=True) for _ in range(self.options.repeats)]
        found = min((json.loads(r.stdout) for r in runs), key=lambda f: f["seconds"])
        self.add("accuracy", problem, "adaptive", target, "truegap", found)

    def add(self, table, problem, kind, size, program, found):
        known = {"table": table, "problem": problem, "mesh": kind, "asked": size, "program": program, "threads": self.options.threads}
        row = {**known, **{k: v for k, v in found.items() if k in FIELDS}, "unknowns": int(found["unknowns"])}
        print({k: row[k] for k in ("problem", "mesh", "asked", "program", "seconds", "peak_mb", "value")}, file=sys.stderr)
        self.rows.append(row)
        self.save(self.options.csv)

    def save(self, file):
        """Replaces the tables that are run in the file, after every row; the others stay."""
        with open(file, "w", newline="") as out:
            writer = csv.DictWriter(out, FIELDS, lineterminator="\n")
            writer.writeheader()
            writer.writerows(self.kept + self.rows)


def install(folder):
    """A venv with the peers; a package that cannot be installed is left out."""
    python = folder / "bin/python"
    if not python.exists():
        venv.create(folder, with_pip=True)
        for package in PACKAGES:
            subprocess.run([python, "-m", "pip", "install", "--quiet", package], check=False)
    return python


if __name__ == "__main__":
    main()
