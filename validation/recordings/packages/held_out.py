"""Errors of models built by hand on the rows that truegap left out: the same rows, in the same parts.

Rows and parts are read from an answer of `truegap diagnose`: prediction.csv has the rows that it used, diagnosis.json names the parts that it left out in turn.
"""

import json
import re
from pathlib import Path

import numpy as np

import table
from problem import Problem


def answer(folder):
    """diagnosis.json of an answer."""
    path = Path(folder) / "diagnosis.json"
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise Problem(f"{path}: {error.strerror}; run bench.py, or `truegap diagnose` with `-o {folder}`") from error
    except json.JSONDecodeError as error:
        raise Problem(f"{path} is no JSON: {error}") from error


def used_rows(response, folder):
    """Index of each row of prediction.csv among the rows of the recording, and its run."""
    columns = table.read(Path(folder) / "prediction.csv")
    recorded = next(values for name, values in columns.items() if name.startswith("recorded_"))
    rows, at = np.empty(len(recorded), int), 0
    tiny = 1e-6 * np.nanmax(np.abs(response))
    for k, value in enumerate(recorded):
        while at < len(response) and not abs(response[at] - value) <= tiny:
            at += 1
        if at == len(response):
            raise Problem(f"{folder}/prediction.csv is not an answer to this recording: no row for its row {k + 1}, {value:g}")
        rows[k], at = at, at + 1
    return rows, columns["run"].astype(int)


def judged_rows(folder):
    """Whether truegap takes an error over each row of prediction.csv: rows for which nothing was recorded on the response's clock have no prediction."""
    columns = table.read(Path(folder) / "prediction.csv")
    return np.isfinite(next(values for name, values in columns.items() if name.startswith("base_held_out")))


def parts(found, runs, judged=None):
    """Positions among the used rows of each part that truegap predicted, by the names that it gave them; those over which it takes an error, where that is given."""
    held = found["fit"].get("held_out")
    if not held:
        raise Problem("the answer has no rows left out")
    named = [part(name, held["how"], runs) for name, *_ in held["parts"]]
    return named if judged is None else [positions[judged[positions]] for positions in named]


def part(name, how, runs):
    """Positions of the rows of `block 2` or of `run 3, 13`."""
    block, blocks = re.fullmatch(r"block (\d+)", name), re.match(r"(\d+) blocks of the one run", how)
    if block and blocks:
        k, n, rows = int(block[1]), int(blocks[1]), len(runs)
        return np.arange((k - 1) * rows // n, k * rows // n)
    if re.fullmatch(r"run \d+(, \d+)*", name):
        return np.flatnonzero(np.isin(runs, [int(number) for number in re.findall(r"\d+", name)]))
    raise Problem(f"rows left out as `{name}` ({how}): neither a block nor runs")


def errors(y, model, rows, left_out):
    """Root-mean-square error of a model in sample and on rows left out."""
    seen = np.zeros(len(y), bool)
    seen[rows] = True
    misses = []
    for positions in left_out:
        others = seen.copy()
        others[rows[positions]] = False
        misses.append((model(others) - y)[rows[positions]])
    return rms((model(seen) - y)[rows]), rms(np.concatenate(misses))


def rms(values):
    """Root mean square."""
    return float(np.sqrt(np.mean(np.square(values))))
