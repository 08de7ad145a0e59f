#!/usr/bin/env python3
"""`validation/verification/peers.md` from `peers.csv`, which `fem.py` writes."""

import csv
import math
import platform
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
FOLDER = ROOT / "validation/verification"
EXACT = {"open": 36.93232194212, "rubber": 1.96621337023}
NAMES = {
    "disc": "Disc capacitor, axisymmetric electrostatics",
    "open": "Disc capacitor in open space, C / (eps0 a) against Love's equation",
    "rubber": "Bonded rubber disc, axisymmetric linear elasticity",
}


def main():
    with open(FOLDER / "peers.csv") as file:
        rows = [{**r, "unknowns": int(r["unknowns"]), "seconds": float(r["seconds"]), "value": float(r["value"])} for r in csv.DictReader(file)]
    threads = rows[0]["threads"]
    lines = [HEAD.format(threads=threads, versions=versions(), machine=platform.machine())]
    for problem in ["disc", "rubber"]:
        lines += sizes([r for r in rows if r["table"] == "sizes" and r["problem"] == problem], problem)
    lines += [ACCURACY]
    for problem in ["open", "rubber"]:
        lines += accuracy([r for r in rows if r["table"] == "accuracy" and r["problem"] == problem], problem)
    lines += [TAIL]
    (FOLDER / "peers.md").write_text("\n".join(lines))


def sizes(rows, problem):
    """Seconds, memory and result of every program at every size."""
    out = [f"\n## {NAMES[problem]}\n", "| unknowns | program | seconds | of truegap's | memory (MB) | result | difference to truegap |", "|---|---|---|---|---|---|---|"]
    summary = []
    for asked in dict.fromkeys(r["asked"] for r in rows):
        group = [r for r in rows if r["asked"] == asked]
        own = next(r for r in group if r["program"] == "truegap")
        for r in group:
            difference = "" if r is own else f"{r['value'] / own['value'] - 1:.1e}"
            out.append(f"| {r['unknowns']} | {r['program']} | {r['seconds']:.3f} | {r['seconds'] / own['seconds']:.2f} | {r['peak_mb']} | {r['value']:.10f} | {difference} |")
        summary.append(verdict(own, [r for r in group if r is not own]))
    return [*out, "", *summary]


def verdict(own, others):
    """The best of the others against truegap, in time and in memory."""
    fast, lean = min(others, key=lambda r: r["seconds"]), min(others, key=lambda r: int(r["peak_mb"]))
    ratio = fast["seconds"] / own["seconds"]
    word = f"{ratio:.2f} times faster than" if ratio >= 1 else f"**{1 / ratio:.2f} times slower than**"
    heavy = int(own["peak_mb"]) / int(lean["peak_mb"])
    memory = f"{heavy:.2f} of the memory of the leanest, {lean['program']}"
    return f"- {own['unknowns']} unknowns: truegap is {word} the fastest of them, {fast['program']}; {memory}."


def accuracy(rows, problem):
    """What a relative error costs: adaptive, uniform (extrapolated where not reached), graded by hand."""
    exact = EXACT[problem]
    error = lambda r: abs(r["value"] / exact - 1)
    uniform = [r for r in rows if r["mesh"] == "uniform"]
    graded = [r for r in rows if r["mesh"] == "graded"]
    out = [f"\n## {NAMES[problem]}\n", "| error asked | how | program | unknowns | seconds | of truegap's | error |", "|---|---|---|---|---|---|---|"]
    for own in [r for r in rows if r["mesh"] == "adaptive"]:
        target = float(own["asked"])
        out.append(f"| {own['asked']} | own refinement, mesh and estimates included | truegap | {own['unknowns']} | {own['seconds']:.3f} | 1 | {error(own):.1e} |")
        best = min((cost(uniform, p, target, error) for p in programs(uniform)), key=lambda c: c["seconds"])
        ratio = best["seconds"] / own["seconds"]
        out.append(f"| {own['asked']} | uniform mesh, {best['how']} | {best['program']} | {best['unknowns']:.2g} | {best['seconds']:.2g} | {ratio:.3g} | {best['error']} |")
        reached = [r for r in graded if error(r) <= target]
        if reached:
            r = min(reached, key=lambda r: r["seconds"])
            out.append(f"| {own['asked']} | mesh graded by truegap's rule, making it not counted | {r['program']} | {r['unknowns']} | {r['seconds']:.3f} | {r['seconds'] / own['seconds']:.2f} | {error(r):.1e} |")
    out += ["", "Measured on uniform meshes:", "", "| unknowns | error | seconds of the fastest |", "|---|---|---|"]
    for asked in dict.fromkeys(r["asked"] for r in uniform):
        r = min((r for r in uniform if r["asked"] == asked), key=lambda r: r["seconds"])
        out.append(f"| {r['unknowns']} | {error(r):.2e} | {r['seconds']:.3f} ({r['program']}) |")
    return out


def programs(rows):
    return list(dict.fromkeys(r["program"] for r in rows))


def cost(rows, program, target, error):
    """Unknowns and seconds at which a program meets a target on uniform meshes: interpolated, or from the last two sizes."""
    own = sorted((r for r in rows if r["program"] == program), key=lambda r: r["unknowns"])
    pairs = list(zip(own, own[1:]))
    inside = [p for p in pairs if error(p[0]) >= target >= error(p[1])]
    a, b = inside[0] if inside else pairs[-1]
    step = math.log(b["unknowns"] / a["unknowns"])
    order, effort = math.log(error(a) / error(b)) / step, math.log(b["seconds"] / a["seconds"]) / step
    factor = (error(b) / target) ** (1 / order)
    how = "between two measured sizes" if inside else f"extrapolated (error as n^-{order:.2f}, time as n^{effort:.2f})"
    return {"program": program, "unknowns": b["unknowns"] * factor, "seconds": b["seconds"] * factor**effort, "how": how, "error": f"{target:.0e}"}


def versions():
    """Versions of the peers that ran."""
    python = ROOT / "target/peers-venv/bin/python"
    listed = subprocess.run([python, "-m", "pip", "list", "--format=freeze"], capture_output=True, text=True).stdout.splitlines() if python.exists() else []
    found = dict(l.split("==") for l in listed if "==" in l)
    names = {"scikit-fem": "scikit-fem", "scikit-sparse": "scikit-sparse (CHOLMOD)", "pypardiso": "pypardiso (PARDISO)", "ngsolve": "NGSolve"}
    words = [f"{label} {found[name]}" for name, label in names.items() if name in found]
    freefem = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", "freefem++"], capture_output=True, text=True).stdout
    return ", ".join(words + ([f"FreeFEM {freefem.split('+')[0]}"] if freefem else []))


HEAD = """# truegap's finite elements beside other programs

Same problem, same mesh (written by truegap), same elements (six-node triangles, displacements alone in elasticity), same run,
{threads} thread for every program ({versions}; {machine}). Seconds are processor seconds from the mesh in memory to the
number asked for: numbering, pattern, assembly, prescribed values, analysis, factorisation, solution, evaluation. Start of the program, imports and
reading the mesh file are not counted. Each is the least of several runs, programs in turn, all of one size in one go; other work on the machine raises such times by up to a half,
the short ones most. FreeFEM counts prescribed unknowns as well. truegap is built as its tests are (`dev` profile: optimisation level
2, dependencies 3), checks the residual of every solve, solves the disc capacitor for each of its two conductors and refines elastic solutions with residuals
formed element by element; the others do none of that. Memory is the greatest of the whole process, interpreter and mesh included."""

ACCURACY = """
# Accuracy for time

truegap starts from the drawing and refines for itself until its own estimate is below the target: seconds include meshing, all levels and all estimates. The others get
their meshes for nothing. On uniform meshes they converge with the singularity at the rim (error about n^-1/2); where a mesh would not fit into the memory of the machine,
the entry is extrapolated from the last two sizes measured, and says so: an order of magnitude. Graded meshes are those of truegap's benches, whose rule was derived from the known singularity; that a program is
handed such a mesh is the best case for it, and then a single solve is cheaper than finding the mesh. In open space truegap has mapped infinite elements, the others a
condition of dipole type on the box of five radii; rubber is mixed in truegap's own refinement (Poisson's ratio 0.49), displacements alone elsewhere."""

TAIL = """
Plots: [disc capacitor](peers_disc.svg), [rubber disc](peers_rubber.svg).

Made by `python3 validation/peers/fem/fem.py`, then `python3 validation/peers/fem/tables.py` and `python3 validation/verification/plots.py`.
"""

if __name__ == "__main__":
    main()
