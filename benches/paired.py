"""Two versions of truegap on the same recordings, in turns: processor time of each, their ratio, and whether the answers are the same.

    python3 benches/paired.py BEFORE NOW RECORDING.toml ... [--times 3] [--csv benches/diagnosis.csv]

BEFORE and NOW are built binaries. A busy machine slows both, so only the ratio of one run is worth keeping: each pair is run one after the other, and the least time of each counts.
Answers are `diagnosis.json`: words must be equal, numbers to a millionth. Exit code 1 where they are not.

Limits: processor time, not wall time; caches that others fill slow both by some per cent.
"""

import argparse
import csv
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

SAME = 1e-6


def differences(before, now, where="") -> list[str]:
    """Places at which two answers differ."""
    if isinstance(before, dict) and isinstance(now, dict):
        if before.keys() != now.keys():
            return [f"{where}: {sorted(before.keys() ^ now.keys())} on one side only"]
        return [d for key in before for d in differences(before[key], now[key], f"{where}.{key}")]
    if isinstance(before, list) and isinstance(now, list):
        if len(before) != len(now):
            return [f"{where}: {len(before)} and {len(now)} entries"]
        return [d for i, pair in enumerate(zip(before, now)) for d in differences(*pair, f"{where}[{i}]")]
    numbers = [isinstance(value, (int, float)) and not isinstance(value, bool) for value in (before, now)]
    same = math.isclose(before, now, rel_tol=SAME, abs_tol=1e-300) if all(numbers) else before == now
    return [] if same else [f"{where}: {before!r} and {now!r}"]


def diagnosed(binary: str, recording: str) -> tuple[float, float, dict]:
    """Processor and wall seconds of one diagnosis, and its answer."""
    with tempfile.TemporaryDirectory() as folder:
        start = time.monotonic()
        child = subprocess.Popen([binary, "-q", "diagnose", recording, "-o", folder], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        _, status, used = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode not in (0, 1):
            sys.exit(f"{binary} diagnose {recording} ended with exit code {child.returncode}")
        answer = json.loads(pathlib.Path(folder, "diagnosis.json").read_text())
        # how long it took is no part of the answer
        del answer["seconds"]
        return used.ru_utime + used.ru_stime, time.monotonic() - start, answer


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before")
    parser.add_argument("now")
    parser.add_argument("recordings", nargs="+")
    parser.add_argument("--times", type=int, default=3)
    parser.add_argument("--csv", type=pathlib.Path)
    asked = parser.parse_args()
    rows, wrong = [], 0
    for recording in asked.recordings:
        pairs = [(diagnosed(asked.before, recording), diagnosed(asked.now, recording)) for _ in range(asked.times)]
        before, now = (min(pair[side][0] for pair in pairs) for side in (0, 1))
        found = differences(pairs[0][0][2], pairs[0][1][2])
        wrong += bool(found)
        answers = "another" if found else "the same" if pairs[0][0][2] == pairs[0][1][2] else "same to a millionth"
        name = "/".join(pathlib.Path(recording).parts[-3:]).removesuffix(".toml")
        rows.append([name, f"{before:.2f}", f"{now:.2f}", f"{before / now:.2f}", answers])
        print(f"{name}: {before:.2f} s before, {now:.2f} s now, {before / now:.2f} times faster; answer: {answers}", flush=True)
        for difference in found[:5]:
            print(f"    {difference}")
    if asked.csv:
        with asked.csv.open("w", newline="") as file:
            csv.writer(file).writerows([["recording", "before, s of processor time", "now, s of processor time", "before / now", "answer"], *rows])
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
