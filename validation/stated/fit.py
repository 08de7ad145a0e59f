#!/usr/bin/env python3
"""The line from the probability among the models to the one that is stated, and how good it is on names that it was not fitted to.

    python3 fit.py [claims.csv] [--table FILE]

A logistic line in the log odds (Platt 1999), by Newton's method, with a penalty of half the square of its slope. Each set is judged by the line of all the others. Exit codes: 0, 2 no such file.
"""

import argparse
import csv
import io
import math
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "recordings" / "packages"))
import table  # noqa: E402
from problem import Problem, command  # noqa: E402

LARGEST = 4.6
STEPS = 50
HEADER = ["set", "names", "right", "stated before", "stated now", "log loss before", "log loss now", "ECE before", "ECE now"]


def log_odds(p):
    p = min(max(p, 1e-12), 1 - 1e-12)
    return max(-LARGEST, min(LARGEST, math.log(p / (1 - p))))


def stated(line, p):
    return 1 / (1 + math.exp(-(line[0] + line[1] * log_odds(p))))


def fitted(claims):
    """Level and slope of the line."""
    level, slope = 0.0, 0.0
    for _ in range(STEPS):
        g0, g1, h00, h01, h11 = 0.0, slope, 0.0, 0.0, 1.0
        for claim in claims:
            x, q = log_odds(claim["p"]), stated((level, slope), claim["p"])
            g0, g1 = g0 + q - claim["right"], g1 + (q - claim["right"]) * x
            weight = q * (1 - q)
            h00, h01, h11 = h00 + weight, h01 + weight * x, h11 + weight * x * x
        determinant = h00 * h11 - h01 * h01
        level -= (h11 * g0 - h01 * g1) / determinant
        slope -= (h00 * g1 - h01 * g0) / determinant
    return level, slope


def judged_unseen(claims):
    """What the line of the other sets states of each name."""
    sets = {claim["set"] for claim in claims}
    lines = {one: fitted([claim for claim in claims if claim["set"] != one]) for one in sets}
    return [stated(lines[claim["set"]], claim["p"]) for claim in claims]


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
    parser.add_argument("--table", metavar="FILE", help="where the CSV is written")
    given = parser.parse_args(arguments)
    try:
        text = Path(given.claims).read_text(encoding="utf-8")
    except OSError as error:
        raise Problem(f"{given.claims} cannot be read: {error}; make it with claims.py") from error
    rows = list(csv.DictReader(io.StringIO(text)))
    claims = [{**row, "p": float(row["among_models"]), "right": int(row["right"])} for row in rows]
    level, slope = fitted(claims)
    print(f"level {level:.3f}, slope {slope:.3f}, from {len(claims)} names", file=sys.stderr)
    unseen = judged_unseen(claims)
    lines = []
    for one in [*dict.fromkeys(claim["set"] for claim in claims), "all"]:
        own = [(claim["p"], q, claim["right"]) for claim, q in zip(claims, unseen) if one in (claim["set"], "all")]
        before, now, right = zip(*own)
        means = [f"{sum(values) / len(values):.2f}" for values in (right, before, now)]
        scores = [f"{of(q, right):.3f}" for of in (log_loss, calibration_error) for q in (before, now)]
        lines.append([one, len(own), *means, *scores])
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows([HEADER, *lines])
    if given.table:
        table.write(given.table, out.getvalue())
    else:
        print(out.getvalue(), end="")
    return 0


if __name__ == "__main__":
    command(main)
