"""Compares the answers of two versions: python3 compare.py BEFORE AFTER, each with a folder a recording that holds diagnosis.json.

Exit code 0 where every field is the same (numbers to 1e-9, `seconds` and `version` left out), 1 where one differs, 2 where there is nothing to compare.
A recording that both versions refused, and so has no answer in either folder, is not counted.
"""

import json
import math
import pathlib
import sys

LEFT_OUT = {"seconds", "version"}
TOLERANCE = 1e-9


def differences(a, b, place=""):
    """Places at which two values differ, with both values."""
    if isinstance(a, dict) and isinstance(b, dict):
        for key in sorted((a.keys() | b.keys()) - LEFT_OUT):
            if key in a and key in b:
                yield from differences(a[key], b[key], f"{place}.{key}")
            else:
                yield f"{place}.{key}", a.get(key, "missing"), b.get(key, "missing")
    elif isinstance(a, list) and isinstance(b, list) and len(a) == len(b):
        for index, (x, y) in enumerate(zip(a, b)):
            yield from differences(x, y, f"{place}[{index}]")
    elif is_number(a) and is_number(b):
        if not math.isclose(a, b, rel_tol=TOLERANCE, abs_tol=TOLERANCE):
            yield place, a, b
    elif a != b:
        yield place, a, b


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def main(before, after):
    answers = [{path.parent.name: path for path in pathlib.Path(folder).glob("*/diagnosis.json")} for folder in (before, after)]
    if not answers[0] or not answers[1]:
        print("no diagnosis.json below one of the folders", file=sys.stderr)
        return 2
    same, names = 0, sorted(answers[0].keys() | answers[1].keys())
    for name in names:
        if name not in answers[0] or name not in answers[1]:
            print(f"{name}: answered by one version only")
            continue
        found = list(differences(*(json.loads(side[name].read_text()) for side in answers)))
        same += not found
        for place, a, b in found[:10]:
            print(f"{name}: {place} {a!r} -> {b!r}")
    print(f"{same} of {len(names)} the same")
    return 0 if same == len(names) else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]) if len(sys.argv) == 3 else print(__doc__) or 2)
