#!/usr/bin/env python3
"""How usual each effect is where a recording could show it, from the right names that were written down before a first run.

    python3 usual.py [--record FILE]

A name has its share of a cause where several are right. A recording could show an effect where the column is there that the effect needs: a clock, a temperature, one driver or two beside the base model's own, runs, an input. A share of `m`
on average, known as well as from `STRENGTH` recordings, is what is taken of an effect beforehand; *usual* is the share over that average. Sets from `UNTIL` on take no part. Exit codes: 0, 2 no such file.
"""

import argparse
import sys
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
PACKAGES = HERE.parent / "recordings" / "packages"
sys.path.insert(0, str(PACKAGES))
import names  # noqa: E402
import table  # noqa: E402
from problem import command  # noqa: E402

STRENGTH = 10.0
UNTIL = "twenty-seventh"
HEADER = ["effect", "usual", "causes", "recordings"]
NEEDS = {
    "clock": "time_offset readout_lag slow_response offset_drift gain_ageing gain_change regime_change clock_rate settling stress_relaxation daily_cycle yearly_cycle",
    "temperature": "temperature_coefficient thermal_lag gain_drift",
    "driver": "driver_coefficient driver_gain late_driver",
    "second driver": "second_driver_coefficient second_driver_gain late_second_driver friction_of_second_driver",
    "input": "nonlinearity saturation friction saturating_loop",
    "runs": "offset_steps",
}


def could_show(recording):
    """Keys of NEEDS that a recording has."""
    columns, base = recording["columns"], recording["base"]["model"]
    drivers = len(recording.get("drivers", {})) + ("humidity" in columns)
    beside = drivers if base == "external" else drivers - 1
    there = {"clock": "time" in columns, "temperature": "temperature" in columns, "driver": beside > 0, "second driver": beside > 1, "input": base == "external" or drivers > 0, "runs": "run" in columns}
    return {what for what, is_there in there.items() if is_there}


def written_down():
    """Right names and the description of each recording of the sets that take part."""
    for of in names.SETS[: names.SETS.index(UNTIL)]:
        for recording, causes in names.right_names(of).items():
            yield causes, tomllib.loads((PACKAGES / "recordings" / f"{recording}.toml").read_text(encoding="utf-8"))


def counted():
    """A row an effect: how usual it is, causes that are its, recordings that could show it."""
    effects = {effect: what for what, of in NEEDS.items() for effect in of.split()}
    causes, could = dict.fromkeys(effects, 0.0), dict.fromkeys(effects, 0)
    for right, recording in written_down():
        there = could_show(recording)
        for effect, what in effects.items():
            could[effect] += what in there
        for cause in right:
            for name in set(cause) & effects.keys():
                causes[name] += 1 / len(cause)
            # an effect that came to the library later was told by the names that it had before
            for later, before in names.CAME_LATER.items():
                causes[later] += len(set(cause) & set(before)) / len(before) / len(cause)
    mean = sum(causes.values()) / sum(could.values())
    usual = {effect: (causes[effect] + STRENGTH * mean) / (could[effect] + STRENGTH) / mean for effect in effects}
    return [[effect, f"{usual[effect]:.3g}", f"{causes[effect]:.1f}", could[effect]] for effect in sorted(effects)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--record", type=Path, help="where the table of the program is written; onto the screen where no file is named")
    table.put(parser.parse_args().record, HEADER, counted())
    return 0


if __name__ == "__main__":
    command(main)
