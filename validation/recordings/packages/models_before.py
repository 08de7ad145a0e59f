#!/usr/bin/env python3
"""What the models built by hand predict on rows left out, before any answer of truegap is there.

    python3 models_before.py RECORDINGS NAME...

RECORDINGS is a folder that fetch.py has written. Rows left out are six blocks in turn, or runs in turn where there are some: each by itself up to ten, else every tenth together.
The model with a star is the one of the table. truegap is not run.
"""

import argparse
from pathlib import Path

import numpy as np

import held_out
import sources
import table
from problem import Problem, command

BLOCKS, PARTS = 6, 10


def left_out(columns, told):
    """Positions of the rows of each part that is left out."""
    runs = columns.get(told.get("columns", {}).get("run", "run"))
    if runs is None or len(np.unique(runs)) == 1:
        rows = len(next(iter(columns.values())))
        return [np.arange(k * rows // BLOCKS, (k + 1) * rows // BLOCKS) for k in range(BLOCKS)]
    names = np.unique(runs)
    return [np.flatnonzero(np.isin(runs, names[k::PARTS])) for k in range(min(PARTS, len(names)))]


def told(recording, folder):
    """Lines about one recording: its rows, and the error of each model in sample and left out."""
    columns = table.read(Path(folder) / recording.name / f"{recording.name}.csv")
    module = recording.module()
    y, models = module.models(columns)
    if module.HAND_BUILT not in models:
        raise Problem(f"{recording.name}: no model is called `{module.HAND_BUILT}`")
    parts = left_out(columns, sources.toml(recording.description))
    yield f"{recording.name} {len(y)} range {np.ptp(y):.4g} sd {y.std():.4g}"
    for name, model in models.items():
        inside, outside = held_out.errors(y, model, np.arange(len(y)), parts)
        yield f"   {'*' if name == module.HAND_BUILT else ' '} {name:36} in {inside:.4g} out {outside:.4g}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("recordings", metavar="RECORDINGS")
    parser.add_argument("names", metavar="NAME", nargs="+")
    given = parser.parse_intermixed_args()
    for recording in sources.chosen(sources.recordings(), given.names):
        print("\n".join(told(recording, given.recordings)), flush=True)
    return 0


if __name__ == "__main__":
    command(main)
