#!/usr/bin/env python3
"""The line from the probability among the models to the one that is stated, and how good it is on claimed names that it was not fitted to.

    python3 fit.py [claims.csv] [--table FILE] [--record FILE]

A logistic line in the log odds (Platt 1999) with a step for a name beside others, one for a name after the first, one for a name that is only carried, and one for each effect, by Newton's method, with a penalty of half the square of each
number but the level: an effect that was named seldom keeps a step near 0. Each set is judged by the line of all the others. *Before* is the probability among the models, *log odds alone* and *with place*
are lines that know less, *now* is the line. Needs numpy. Exit codes: 0, 2 no such file.
"""

import argparse
import csv
import io
import math
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "recordings" / "packages"))
import table  # noqa: E402
from problem import Problem, command  # noqa: E402

LARGEST = 4.6
HIGH = 0.85
STEPS = 50
HEADER = ["set", "names", "right"] + [f"{of} {by}" for of in ("stated", "log loss", "ECE") for by in ("before", "log odds alone", "with place", "now")]
RECORD = ["effect", "log_odds", "names", "right"]
TERMS = ("level", "slope", "beside others", "later", "carried")
COUNTS = ("place", "names", "carried", "right")


def log_odds(p):
    p = min(max(p, 1e-12), 1 - 1e-12)
    return max(-LARGEST, min(LARGEST, math.log(p / (1 - p))))


def terms(claims, known, effects):
    """What the line sees of each name (names x terms): 1, its log odds, whether it stands beside others, whether after the first, whether it is only carried, and which of the `effects` it is; the first `known` of these."""
    own = [[1.0, log_odds(c["p"]), c["names"] > 1, c["place"] > 1, c["carried"]] + [c["effect"] == effect for effect in effects] for c in claims]
    return np.array(own, float)[:, :known]


def stated(line, seen):
    return 1 / (1 + np.exp(-np.dot(seen, line)))


def fitted(seen, right):
    """Numbers of the line, from the terms of each name (names x terms) and whether it is right."""
    line = np.zeros(seen.shape[1])
    penalty = np.array([0.0] + [1.0] * (len(line) - 1))
    for _ in range(STEPS):
        q = stated(line, seen)
        curvature = seen.T @ (seen * (q * (1 - q))[:, None]) + np.diag(penalty)
        line -= np.linalg.solve(curvature, seen.T @ (q - right) + penalty * line)
    return line


def judged_unseen(claims, known, effects):
    """What the line of the other sets states of each name."""
    sets = np.array([claim["set"] for claim in claims])
    seen, right = terms(claims, known, effects), np.array([claim["right"] for claim in claims])
    unseen = np.zeros(len(claims))
    for one in set(sets):
        unseen[sets == one] = stated(fitted(seen[sets != one], right[sets != one]), seen[sets == one])
    return unseen


def log_loss(q, right):
    return -sum(math.log(max(p if r else 1 - p, 1e-9)) for p, r in zip(q, right)) / len(q)


def calibration_error(q, right):
    """Ten bins of equal width, as in the studies' scores (Guo et al. 2017, eq. 3)."""
    off = [0.0] * 10
    for p, r in zip(q, right):
        off[min(int(10 * p), 9)] += p - r
    return sum(map(abs, off)) / len(q)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("claims", nargs="?", default=HERE / "claims.csv")
    parser.add_argument("--table", metavar="FILE", help="where the CSV of how good it is is written")
    parser.add_argument("--record", metavar="FILE", help="where the CSV of what each effect adds is written")
    given = parser.parse_args(arguments)
    try:
        text = Path(given.claims).read_text(encoding="utf-8")
    except OSError as error:
        raise Problem(f"{given.claims} cannot be read: {error}; make it with claims.py") from error
    rows = list(csv.DictReader(io.StringIO(text)))
    claims = [{**{name: row[name] for name in ("set", "effect")}, "p": float(row["among_models"]), **{name: int(row[name]) for name in COUNTS}} for row in rows]
    effects = sorted({claim["effect"] for claim in claims})
    everything = len(TERMS) + len(effects)
    line = fitted(terms(claims, everything, effects), np.array([claim["right"] for claim in claims]))
    print(", ".join(f"{name} {value:.3f}" for name, value in zip(TERMS, line)), f"from {len(claims)} names", file=sys.stderr)
    unseen = [judged_unseen(claims, known, effects) for known in (2, len(TERMS), everything)]
    high = [(q, claim["right"]) for q, claim in zip(unseen[-1], claims) if q >= HIGH and not claim["carried"]]
    mean, right = (sum(values) / len(high) for values in zip(*high))
    print(f"stated at {HIGH} and more on sets that it was not fitted to: {len(high)} names, {mean:.2f} on average, {right:.2f} right", file=sys.stderr)
    lines = []
    for one in [*dict.fromkeys(claim["set"] for claim in claims), "all"]:
        own = [(claim["p"], *q, claim["right"]) for claim, *q in zip(claims, *unseen) if one in (claim["set"], "all") and not claim["carried"]]
        *by, right = zip(*own)
        means = [f"{sum(values) / len(values):.2f}" for values in (right, *by)]
        scores = [f"{of(q, right):.3f}" for of in (log_loss, calibration_error) for q in by]
        lines.append([one, len(own), *means, *scores])
    table.put(given.table, HEADER, lines)
    if given.record:
        of = lambda effect: [claim["right"] for claim in claims if claim["effect"] == effect]  # noqa: E731
        own = [[effect, f"{step:.3f}", len(of(effect)), sum(of(effect))] for effect, step in zip(effects, line[len(TERMS) :])]
        table.put(given.record, RECORD, own)
    return 0


if __name__ == "__main__":
    command(main)
