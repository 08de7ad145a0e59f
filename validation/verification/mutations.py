#!/usr/bin/env python3
"""Plants every error of `mutations.toml` in a copy of the finite-element crate and sees whether its tests notice.

    python3 validation/verification/mutations.py [NAME...] [--scratch target/mutations]

Every mutation names a file of `crates/truegap-fem/src`, the text that it replaces (which must occur there exactly once), what it puts in
its place, and the tests that should fail: a target, perhaps with a part of their names. `killed`: a test failed, or did not end in five minutes; `survived`: all passed.
A mutation that does not compile, or whose text is not there, ends the run: then the list is out of date. Writes `mutations.md`; with
names only those are tried again, and the outcomes of the others are those that stand there, each with the commit that it was run on. What has
none there was not run yet, and is not counted. Exit code 1 where one survives.
The copy is built in its own `target`, whatever CARGO_TARGET_DIR says.
"""

import argparse
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
LIMIT = 300  # s
NOT_RUN = {"outcome": "not run yet", "by": "", "count": "", "on": ""}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--scratch", type=Path, default=ROOT / "target/mutations")
    options = parser.parse_args()
    mutations = tomllib.loads((HERE / "mutations.toml").read_text())["mutation"]
    chosen = [m for m in mutations if not options.names or m["name"] in options.names]
    crate = copy(options.scratch)
    for target in sorted({m["test"] for m in chosen}):
        outcome, _, detail = run(options.scratch, target)
        if outcome != "survived":
            sys.exit(f"the tests of {target} do not pass without any mutation:\n{detail}")
    outcomes = kept()
    for mutation in chosen:
        row = {**attempt(options.scratch, crate, mutation), "on": commit()}
        print(f"{row['outcome']:9} {row['seconds']:5.0f} s  {mutation['name']}  {row['by']}", flush=True)
        outcomes[mutation["why"], mutation["file"]] = row
        rows = [{**m, **outcomes.get((m["why"], m["file"]), NOT_RUN)} for m in mutations]
        (HERE / "mutations.md").write_text(page(rows))
    sys.exit(any(outcomes[m["why"], m["file"]]["outcome"] == "survived" for m in chosen))


def kept():
    """Outcomes that stand on the page, by what is wrong and its file."""
    rows = [line.strip("| \n").split(" | ") for line in (HERE / "mutations.md").read_text().splitlines() if line.startswith("| ")]
    rows = [row for row in rows if len(row) == 7 and row[3] in ("killed", "survived")]
    return {(why, file.strip("`")): {"outcome": outcome, "by": by, "count": int(count), "on": on} for why, file, _, outcome, by, count, on in rows}


def commit():
    return subprocess.run(["git", "rev-parse", "--short=7", "HEAD"], cwd=ROOT, capture_output=True, text=True).stdout.strip()


def copy(scratch):
    """A workspace of its own with this crate and what its tests read; its target folder stays from run to run."""
    crate = scratch / "crates/truegap-fem"
    for folder in ["crates/truegap-fem", "crates/truegap-limits", "meshes", "validation/verification"]:
        shutil.rmtree(scratch / folder, ignore_errors=True)
        # files as young as the copy: what an earlier run built there may be newer than the files copied
        shutil.copytree(ROOT / folder, scratch / folder, copy_function=shutil.copyfile)
    manifest = (ROOT / "Cargo.toml").read_text()
    manifest = re.sub(r"members = \[.*\]", 'members = ["crates/truegap-fem"]', manifest, count=1)
    manifest = re.sub(r"default-members = \[.*\]\n", "", manifest, count=1)
    manifest = re.sub(r'^truegap(?!-limits)[a-z-]* = \{ path.*\n', "", manifest, flags=re.MULTILINE)
    (scratch / "Cargo.toml").write_text(manifest)
    shutil.copy(ROOT / "Cargo.lock", scratch / "Cargo.lock")
    return crate


def attempt(scratch, crate, mutation):
    """Plants one error, runs its tests, takes the error out again."""
    file = crate / "src" / mutation["file"]
    right = file.read_text()
    if right.count(mutation["from"]) != 1:
        sys.exit(f"{mutation['name']}: `{mutation['from']}` occurs {right.count(mutation['from'])} times in {mutation['file']}")
    try:
        file.write_text(right.replace(mutation["from"], mutation["to"]))
        outcome, seconds, detail = run(scratch, mutation["test"])
    finally:
        file.write_text(right)
    failed = re.findall(r"^test (\S+) \.\.\. FAILED", detail, flags=re.MULTILINE)
    if outcome == "killed" and not failed:
        if "could not compile" in detail:
            sys.exit(f"{mutation['name']} does not compile:\n{detail[-2000:]}")
        failed = ["time limit"]
    return {"outcome": outcome, "seconds": seconds, "by": ", ".join(f"`{f}`" for f in failed[:2]), "count": len(failed)}


def building(scratch):
    """The environment of a build: a target folder of the copy's own, as two copies with one take each other's programs for theirs."""
    return {**os.environ, "CARGO_TARGET_DIR": str(scratch.resolve() / "target")}


def run(scratch, target):
    """Outcome of the tests of a target: what they print, and how long building and testing took."""
    command = ["cargo", "test", "--quiet", "-p", "truegap-fem", *target.split()]
    begin = time.monotonic()
    built = subprocess.run([*command, "--no-run"], cwd=scratch, env=building(scratch), capture_output=True, text=True)
    if built.returncode:
        return "killed", time.monotonic() - begin, built.stderr
    tests = subprocess.Popen([*command, "--", "--format=pretty"], cwd=scratch, env=building(scratch), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True)
    try:
        detail, failed = tests.communicate(timeout=LIMIT)[0], tests.returncode != 0
    except subprocess.TimeoutExpired:
        os.killpg(tests.pid, signal.SIGKILL)
        detail, failed = "", True
    return "killed" if failed else "survived", time.monotonic() - begin, detail


def page(rows):
    killed = sum(r["outcome"] == "killed" for r in rows)
    run = sum(r["outcome"] in ("killed", "survived") for r in rows)
    left = f" {len(rows) - run} more of the list were not run yet." if run < len(rows) else ""
    lines = [
        "# Planted errors in the finite elements, and the tests that notice them",
        "",
        f"{killed} of {run} killed.{left} Each is planted alone in a copy of the crate, and the tests named beside it are run (`mutations.toml`).",
        "",
        "| what is wrong | file | tests run | outcome | noticed by (first two of) | tests | run on |",
        "|---|---|---|---|---|---|---|",
    ]
    for r in rows:
        lines.append(f"| {r['why']} | `{r['file']}` | `{r['test']}` | {r['outcome']} | {r['by']} | {r['count']} | {r['on']} |")
    lines += ["", "Made by `python3 validation/verification/mutations.py`.", ""]
    return "\n".join(lines)


if __name__ == "__main__":
    main()
