#!/usr/bin/env python3
"""truegap's design search beside NSGA-II of pymoo: same problem, same number of evaluations, same run.

    python3 -m venv venv && venv/bin/pip install pymoo
    cargo build -p truegap-design --example front
    venv/bin/python validation/peers/nsga2.py [--seeds 5] [--front target/debug/examples/front]

What is compared. truegap searches with its own equations. NSGA-II (population 100, pymoo's defaults) sees the same unit cube, the same
steps for foils and beads and the same constraints, through the port of the equations below: numpy, a whole population at once, so that
Python's own slowness is met once a generation and not once a design. The port was written from the paper, docs/errata.md and
docs/theory.md; it shares no code with truegap. Before anything is timed, every tenth design of truegap's fronts goes through the port; the
largest difference is printed, and more than 1e-6 of a coefficient ends the run (NSGA-II itself gets a coarser scan for the linearity
error, which is faster: 1e-3 of a coefficient at worst). Hypervolumes of both are computed by pymoo's indicator
with the starting design (all ratios 1) as reference point: 0 is no gain, 1 all coefficients zero.
"""

import argparse
import json
import os
import statistics
import subprocess
import time

import numpy as np
from pymoo.algorithms.moo.nsga2 import NSGA2
from pymoo.core.problem import Problem
from pymoo.indicators.hv import HV
from pymoo.optimize import minimize

EPS0 = 8.854e-12
COLD, HOT = 20.0, 50.0
LOADS = 33
FINE = 1025


def strain(q, nu):
    """e (1 + nu e)^2 = q for compressive strain e, by Newton from below the root's double."""
    e = q / (1.0 + nu * q) ** 2
    for _ in range(30):
        spread = 1.0 + nu * e
        step = (e * spread**2 - q) / (spread * (1.0 + 3.0 * nu * e))
        e = e - step
        if np.all(np.abs(step) < 1e-14):
            break
    return e


def curvature(tin, copper, h1, h2, kelvin):
    """(8), (9) as curvature; thicknesses expanded."""
    e1, e2 = tin["young"], copper["young"]
    h1 = h1 * (1.0 + tin["expansion"] * kelvin)
    h2 = h2 * (1.0 + copper["expansion"] * kelvin)
    mismatch = (tin["expansion"] - copper["expansion"]) * kelvin
    stiff = e1**2 * h1**4 + e1 * e2 * h1 * h2 * (4.0 * h1**2 + 6.0 * h1 * h2 + 4.0 * h2**2) + e2**2 * h2**4
    return 6.0 * e1 * e2 * h1 * h2 * (h1 + h2) * mismatch / stiff


def response(c, design, temperature, shares):
    """Capacitance in pF for every design (rows) and load (columns), and whether the plates stay apart."""
    kelvin = temperature - c["reference_c"]
    rubber, copper, tin, film = c["rubber"], c["conductor"], c["plating"], c["insulator"]
    d = {name: value[:, None] for name, value in design.items()}
    radius = 0.5 * d["diameter"] * (1.0 + copper["expansion"] * kelvin)
    electrode = np.pi * radius**2
    beads = d["bead_count"] * 0.25 * np.pi * d["bead_diameter"] ** 2 * (1.0 + rubber["expansion"] * kelvin) ** 2
    young = d["young"] + c["softening"] * kelvin
    force = shares[None, :] * c["full_scale"]
    e = strain(force / (beads * young), c["poisson"])
    height = d["height"] * (1.0 + rubber["expansion"] * kelvin) * (1.0 - e)
    film_free = d["insulator"] * (1.0 + film["expansion"] * kelvin)
    film_loaded = film_free * (1.0 - force / (electrode * film["young"]))
    solid = beads * (1.0 + c["poisson"] * e) ** 2
    mixed = c["surrounding"] + (rubber["permittivity"] - c["surrounding"]) * solid / electrode
    k = curvature(tin, copper, d["plating"], d["conductor"], kelvin)
    cosine = np.sqrt(1.0 - (k * radius) ** 2)
    sag = k * radius**2 / (1.0 + cosine)
    centre = height - sag * (1.0 + 2.0 * cosine) / (3.0 * (1.0 + cosine))
    apart = (e < 1.0) & (centre > 0.0) & (centre + sag > 0.0) & (film_loaded > 0.0)
    g = np.where(apart, centre, 1.0)
    s = np.where(apart, sag, 0.0)
    x = s / g
    with np.errstate(invalid="ignore", divide="ignore"):
        over = np.where(np.abs(x) < 1e-9, 1.0 - 0.5 * x, np.log1p(x) / x)
    integral = 2.0 * np.pi * (radius**2 / (g * (1.0 + cosine)) * over + g * (np.log1p(x) - x))
    c_beads = EPS0 * mixed * integral
    c_film = EPS0 * film["permittivity"] * electrode / film_loaded
    c_tail = 2.0 * EPS0 * film["permittivity"] * c["tail"][0] * c["tail"][1] / film_free
    total = c_beads * c_film / (c_beads + c_film) + c_film + c_tail + c["stray"]
    return 1e12 * total, apart.all(axis=1)


def linearity(curve):
    """Largest distance from the line through the ends, % of the span: the worst of equal loads, then the parabola through its neighbours."""
    loads = np.linspace(0.0, 1.0, curve.shape[1])
    span = curve[:, -1] - curve[:, 0]
    off = np.abs(100.0 * ((curve - curve[:, :1]) / span[:, None] - loads[None, :]))
    at = np.clip(off.argmax(axis=1), 1, len(loads) - 2)
    rows = np.arange(len(curve))
    left, top, right = off[rows, at - 1], off[rows, at], off[rows, at + 1]
    bend = left - 2.0 * top + right
    with np.errstate(invalid="ignore", divide="ignore"):
        peak = top - np.where(bend == 0.0, 0.0, (left - right) ** 2 / (8.0 * bend))
    return peak


def metrics(c, design, loads):
    """Baseline, span, linearity error, three coefficients (K_baseline in pF/K), and whether the plates stay apart."""
    shares = np.linspace(0.0, 1.0, loads)
    cold, apart = response(c, design, COLD, shares)
    hot, apart_hot = response(c, design, HOT, shares)
    kelvin = HOT - COLD
    span, span_hot = cold[:, -1] - cold[:, 0], hot[:, -1] - hot[:, 0]
    bent, bent_hot = linearity(cold), linearity(hot)
    coefficients = [(hot[:, 0] - cold[:, 0]) / kelvin, 100.0 * (span_hot / span - 1.0) / kelvin, (bent_hot - bent) / kelvin]
    return cold[:, 0], span, bent, np.stack(coefficients, axis=1), apart & apart_hot


class Design:
    """The problem as truegap prints it."""

    def __init__(self, told, loads):
        self.c, self.axes, self.useful, self.loads = told["sensor"], told["axes"], told["useful"], loads
        start = {
            "young": self.c["rubber"]["young"], "height": self.c["rubber"]["thickness"], "conductor": self.c["conductor"]["thickness"],
            "plating": self.c["plating"]["thickness"], "insulator": self.c["insulator"]["thickness"],
            "bead_diameter": self.c["bead_diameter"], "bead_count": float(self.c["bead_count"]), "diameter": self.c["diameter"],
        }
        self.base = metrics(self.c, {name: np.array([value]) for name, value in start.items()}, loads)

    def values(self, cube):
        """Designs at points of the unit cube: ranges, levels, whole numbers."""
        design = {}
        for i, axis in enumerate(self.axes):
            u, choice = cube[:, i], axis["choice"]
            if "continuous" in choice:
                low, high = choice["continuous"]
                design[axis["quantity"]] = low + u * (high - low)
            else:
                whole = choice.get("whole")
                levels = np.arange(whole[0], whole[1] + 1.0) if whole else np.array(choice["levels"])
                design[axis["quantity"]] = levels[np.minimum((u * len(levels)).astype(int), len(levels) - 1)]
        return design

    def judged(self, design):
        """Ratios of the coefficients and violations of the constraints."""
        baseline, span, bent, coefficients, apart = metrics(self.c, design, self.loads)
        base_baseline, base_span, base_bent, base_coefficients, _ = self.base
        ratios = np.abs(coefficients / base_coefficients)
        covered = design["bead_count"] * (design["bead_diameter"] / design["diameter"]) ** 2
        good = lambda value: np.where(apart, value, 0.0)
        violations = np.stack([
            np.where(apart, -1.0, 1.0),
            covered / self.useful["covered"] - 1.0,
            good(1.0 - baseline / base_baseline / self.useful["baseline"]),
            good(1.0 - span / base_span / self.useful["span"]),
            good(bent / base_bent / self.useful["linearity"] - 1.0),
        ], axis=1)
        return np.where(apart[:, None], ratios, 1e6), violations


class Cube(Problem):
    def __init__(self, design, objectives):
        super().__init__(n_var=len(design.axes), n_obj=len(objectives), n_ieq_constr=5, xl=0.0, xu=1.0)
        self.design, self.objectives, self.seconds = design, objectives, 0.0

    def _evaluate(self, cube, out, *_, **__):
        begin = time.perf_counter()
        ratios, violations = self.design.judged(self.design.values(cube))
        out["F"], out["G"] = ratios[:, self.objectives], violations
        self.seconds += time.perf_counter() - begin


def nsga2(design, objectives, evaluations, seed):
    """Everything feasible that NSGA-II met, its seconds, and of these the seconds in the equations."""
    problem = Cube(design, objectives)
    met = []
    keep = lambda algorithm: met.append(algorithm.pop.get("F")[algorithm.pop.get("FEAS").ravel()])
    begin = time.perf_counter()
    result = minimize(problem, NSGA2(pop_size=100), ("n_eval", evaluations), seed=seed, callback=keep)
    seconds = time.perf_counter() - begin
    return result.F, np.concatenate(met), seconds, problem.seconds, result.algorithm.evaluator.n_eval


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--seeds", type=int, default=5)
    arguments.add_argument("--front", default="target/debug/examples/front")
    asked = arguments.parse_args()
    run = lambda threads: json.loads(
        subprocess.run([asked.front, str(asked.seeds)], check=True, capture_output=True, env={**os.environ, "RAYON_NUM_THREADS": threads}).stdout
    )
    one, told = run("1"), run(str(os.cpu_count()))
    assert [f["designs"] for f in one["fronts"]] == [f["designs"] for f in told["fronts"]], "threads changed a front"
    design, fine = Design(told, LOADS), Design(told, FINE)

    differences, count = {LOADS: 0.0, FINE: 0.0}, 0
    for front in told["fronts"]:
        # every tenth: the fine scan of all takes minutes
        values = np.array([d["values"] for d in front["designs"]])[::10]
        known = np.array([d["ratios"] for d in front["designs"]])[::10]
        count += len(values)
        for port in (design, fine):
            ratios, violations = port.judged({a["quantity"]: values[:, i] for i, a in enumerate(told["axes"])})
            differences[port.loads] = max(differences[port.loads], np.abs(ratios - known).max())
            assert (violations < 1e-4).all(), "the port finds a design of truegap infeasible"
    print(f"{count} designs of truegap through the port, all feasible; ratios differ by at most {differences[FINE]:.1e} with {FINE} loads, {differences[LOADS]:.1e} with the {LOADS} that NSGA-II gets\n")
    assert differences[FINE] < 1e-6 and differences[LOADS] < 1e-3, "the port and truegap do not agree"

    print(f"medians of {asked.seeds} seeds; hypervolume with the starting design as reference; NSGA-II: its last population, and all that it ever held\n")
    print("| front of | evaluations | hypervolume truegap | NSGA-II, last | NSGA-II, ever | truegap 1 thread, s |"
          f" truegap {told['threads']} threads, s | NSGA-II, s | of it equations, s | faster, 1 thread | faster, all |")
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    for number in range(4):
        rows = []
        for seed in range(asked.seeds):
            ours, single = told["fronts"][4 * seed + number], one["fronts"][4 * seed + number]
            objectives = ours["objectives"]
            volume = HV(ref_point=np.ones(len(objectives)))
            last, ever, seconds, equations, evaluations = nsga2(design, objectives, ours["evaluations"], seed + 1)
            found = np.array([d["ratios"] for d in ours["designs"]])[:, objectives]
            rows.append((ours["evaluations"], evaluations, volume(found), volume(last), volume(front_of(ever)), single["seconds"],
                         ours["seconds"], seconds, equations))
        ours, theirs, a, b, c, t1, t, s, q = (statistics.median(column) for column in zip(*rows))
        names = ", ".join(told["objectives"][o] for o in objectives)
        print(f"| {names} | {ours:.0f} / {theirs:.0f} | {a:.5f} | {b:.5f} | {c:.5f} | {t1:.3f} | {t:.3f} | {s:.2f} | {q:.2f} | {s / t1:.0f} x | {s / t:.0f} x |")


def front_of(points):
    """Points that no other beats, sorted by the first objective."""
    points = np.unique(points, axis=0)
    kept = np.empty((0, points.shape[1]))
    for point in points:
        if not (kept <= point).all(axis=1).any():
            kept = np.vstack([kept, point])
    return kept


if __name__ == "__main__":
    main()
