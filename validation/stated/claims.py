#!/usr/bin/env python3
"""Names that diagnoses stated, with what the models gave them and whether they are right.

    python3 claims.py ANSWERS -o claims.csv

ANSWERS holds one folder a recording of validation/recordings/packages, as its bench.py writes them; those sets count whose right names were written down before the first run. Effects of the
library count, as in the scores of generated studies. What an answer only carries follows what it claims. A recording without an answer is counted on the error stream and left out.
Exit codes: 0, 2 nothing is answered.
"""

import argparse
import sys
from pathlib import Path

PACKAGES = Path(__file__).resolve().parent.parent / "recordings" / "packages"
sys.path.insert(0, str(PACKAGES))
import names  # noqa: E402
import table  # noqa: E402
from problem import Problem, command  # noqa: E402

HEADER = ["set", "recording", "effect", "among_models", "detectability", "place", "names", "carried", "right"]


# a thermometer that follows late has one cause, however it was written down: the program calls it after the temperature where the reading is one
OF_A_THERMOMETER = {"thermal_lag": ["slow_response", "readout_lag"]}
TEMPERATURES = ("°C", "degC", "K")


def claims(of, recording, diagnosis, right):
    same = {**names.CAME_LATER, **(OF_A_THERMOMETER if diagnosis["fit"]["unit"] in TEMPERATURES else {})}
    told, carried = diagnosis["findings"], diagnosis.get("carried", [])
    for place, finding in enumerate(told + carried, 1):
        if finding["effect"].startswith("discovered"):
            continue
        among_models = finding.get("probability_among_models", finding["probability"])
        yield [
            of,
            recording,
            finding["effect"],
            f"{among_models:.6g}",
            f"{finding['detectability'] or 0:.4g}",
            place,
            len(told) + (place > len(told)),
            int(place > len(told)),
            int(any(name in right for name in [finding["effect"], *same.get(finding["effect"], [])])),
        ]


def of_packages(answers):
    every = [(of, recording, causes) for of in names.SETS for recording, causes in names.right_names(of).items()]
    answered = [one for one in every if (Path(answers) / one[1] / "diagnosis.json").exists()]
    print(f"{len(answered)} of {len(every)} recordings are answered", file=sys.stderr)
    if not answered:
        raise Problem(f"{answers} holds no answer to a recording with written names; diagnose them first (bench.py)")
    for of, recording, causes in answered:
        right = {name for cause in causes for name in cause}
        yield from claims(of, recording, names.answer(answers, recording), right)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("answers", metavar="ANSWERS")
    parser.add_argument("-o", metavar="FILE", required=True)
    given = parser.parse_args(arguments)
    table.put(given.o, HEADER, of_packages(given.answers))
    return 0


if __name__ == "__main__":
    command(main)
