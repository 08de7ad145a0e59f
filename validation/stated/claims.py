#!/usr/bin/env python3
"""Names that diagnoses stated, with what the models gave them and whether they are right.

    python3 claims.py ANSWERS -o claims.csv

ANSWERS holds one folder a recording of validation/recordings/packages, as its bench.py writes them; those sets count whose right names were written down before the first run. Effects of the
library count, as in the scores of generated studies. Exit codes: 0, 2 a file is missing.
"""

import argparse
import sys
from pathlib import Path

PACKAGES = Path(__file__).resolve().parent.parent / "recordings" / "packages"
sys.path.insert(0, str(PACKAGES))
import names  # noqa: E402
import table  # noqa: E402
from problem import command  # noqa: E402

HEADER = ["set", "recording", "effect", "among_models", "detectability", "place", "names", "right"]


def claims(of, recording, diagnosis, right):
    told = diagnosis["findings"]
    for place, finding in enumerate(told, 1):
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
            len(told),
            int(any(name in right for name in [finding["effect"], *names.CAME_LATER.get(finding["effect"], [])])),
        ]


def of_packages(answers):
    for of in names.SETS:
        for recording, causes in names.right_names(of).items():
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
