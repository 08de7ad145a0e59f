#!/usr/bin/env python3
"""Plants the errors of mutants.toml one by one and counts those that the tests named beside them notice.

    python3 validation/mutants/mutants.py              # all, and the table in README.md
    python3 validation/mutants/mutants.py NAME...      # some; of the others the outcomes on the page stay, each with the commit that it was run on
    python3 validation/mutants/mutants.py --scratch DIR    # in another folder: one for each run at the same time

Nothing is planted here: `target/mutants` holds a copy of the crates, in which every error stands beside the right text and is chosen by a number in the
environment. So each crate is built once (about a minute for the diagnosis, and the first time the libraries that it uses), and each error costs what its
test takes. The copy is built in its own `target`, whatever CARGO_TARGET_DIR says: cargo knows a crate by its path inside the workspace and by the age of
its files, so that two copies with one target folder take each other's programs for theirs. A mutant is killed where the named test
fails or runs for more than a minute; without any error all of them must pass.
"""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import time
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
CRATES = ["truegap-core", "truegap-model", "truegap-design", "truegap-diagnose"]
# those that these need, in which nothing is planted
NEEDED = ["truegap-limits"]
LIMIT = 60  # s
CHOICE = """
/// Which error is planted: a number in the environment.
#[allow(missing_docs)]
pub mod planted {
    static NUMBER: std::sync::LazyLock<u32> =
        std::sync::LazyLock::new(|| std::env::var("TRUEGAP_PLANTED").ok().and_then(|n| n.parse().ok()).unwrap_or(0));
    pub fn planted(number: u32) -> bool {
        *NUMBER == number
    }
}
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--scratch", type=Path, default=ROOT / "target/mutants")
    options = parser.parse_args()
    mutants = tomllib.loads((HERE / "mutants.toml").read_text())["mutant"]
    for number, mutant in enumerate(mutants, 1):
        mutant["number"] = number
    chosen = [m for m in mutants if not options.names or m["name"] in options.names]
    copy(options.scratch)
    plant(options.scratch, mutants)
    begin = time.monotonic()
    targets = build(options.scratch, chosen)
    built = time.monotonic() - begin
    for test in sorted({(m["crate"], m.get("target", "lib"), m["test"]) for m in chosen}):
        passed, ran, detail = run(options.scratch, targets, *test, 0)
        if not passed or not ran:
            sys.exit(f"{test} does not pass without any error planted, or names no test:\n{detail[-2000:]}")
    rows, outcomes = [], kept()
    for mutant in chosen:
        begin = time.monotonic()
        passed, _, detail = run(options.scratch, targets, mutant["crate"], mutant.get("target", "lib"), mutant["test"], mutant["number"])
        failed = re.findall(r"^test (\S+) \.\.\. FAILED", detail, flags=re.MULTILINE)
        rows.append({**mutant, "killed": not passed, "seconds": time.monotonic() - begin, "by": failed})
        outcomes[mutant["why"], mutant["file"]] = {"killed": not passed, "on": commit()}
        (HERE / "README.md").write_text(page([{**m, **outcomes[m["why"], m["file"]]} for m in mutants if (m["why"], m["file"]) in outcomes]))
        print(f"{'killed' if not passed else 'SURVIVED':8} {rows[-1]['seconds']:5.1f} s  {mutant['name']}", flush=True)
    killed = sum(r["killed"] for r in rows)
    print(f"{killed} of {len(rows)} killed; built in {built:.0f} s")


def kept():
    """Outcomes that stand on the page, by what is wrong and its file."""
    rows = [line.strip("| \n").split(" | ") for line in (HERE / "README.md").read_text().splitlines() if line.startswith("| ")]
    rows = [row for row in rows if len(row) == 6 and row[3] in ("killed", "not noticed")]
    return {(why, file.strip("`")): {"killed": outcome == "killed", "on": on} for why, _, file, outcome, _, on in rows}


def commit():
    return subprocess.run(["git", "rev-parse", "--short=7", "HEAD"], cwd=ROOT, capture_output=True, text=True).stdout.strip()


def copy(scratch):
    """A workspace of its own with these crates and what their tests read; its target folder stays from run to run."""
    for folder in [f"crates/{c}" for c in CRATES + NEEDED] + ["docs", "meshes", "validation/stated"]:
        shutil.rmtree(scratch / folder, ignore_errors=True)
        # files as young as the copy: cargo would take an older text for one that was built
        shutil.copytree(ROOT / folder, scratch / folder, copy_function=shutil.copyfile)
    manifest = (ROOT / "Cargo.toml").read_text()
    members = ", ".join(f'"crates/{c}"' for c in CRATES + NEEDED)
    manifest = re.sub(r"^members = \[.*\]", f"members = [{members}]", manifest, count=1, flags=re.MULTILINE)
    manifest = re.sub(r"^default-members = \[.*\]\n", "", manifest, count=1, flags=re.MULTILINE)
    manifest = manifest.replace('missing_docs = "warn"', 'missing_docs = "allow"\nunused = "allow"')
    # every mutant asks a number in inner loops, and tests of one stage are small: a fast build is worth more than fast code
    manifest += "".join(f"\n[profile.dev.package.{c}]\nopt-level = {0 if c == 'truegap-diagnose' else 1}\ndebug = false\n" for c in CRATES if f"package.{c}]" not in manifest)
    (scratch / "Cargo.toml").write_text(manifest)
    shutil.copy(ROOT / "Cargo.lock", scratch / "Cargo.lock")
    shutil.copy(ROOT / "rustfmt.toml", scratch / "rustfmt.toml")


def plant(scratch, mutants):
    """Puts every error beside the right text. `at` names text that stands once in the file, with the expression to change between « and »."""
    edits = {}
    for m in mutants:
        file = scratch / "crates" / m["crate"] / "src" / m["file"]
        text = file.read_text()
        before, right, after = re.fullmatch(r"(?s)(.*)«(.*)»(.*)", m["at"]).groups()
        whole = before + right + after
        if text.count(whole) != 1:
            sys.exit(f"{m['name']}: `{whole}` stands {text.count(whole)} times in {m['file']}")
        start = text.index(whole) + len(before)
        edits.setdefault(file, []).append((start, start + len(right), m))
    for file, places in edits.items():
        text = file.read_text()
        places.sort(key=lambda p: p[0], reverse=True)
        for (start, end, m), later in zip(places, [(len(text), 0, None), *places]):
            if end > later[0]:
                sys.exit(f"{m['name']} and {later[2]['name']} change the same text")
            text = f"{text[:start]}(if crate::planted::planted({m['number']}) {{ {m['to']} }} else {{ {text[start:end]} }}){text[end:]}"
        file.write_text(text)
    for crate in CRATES:
        library = scratch / "crates" / crate / "src/lib.rs"
        library.write_text(library.read_text() + CHOICE)


def build(scratch, chosen):
    """Test programs by crate and target."""
    programs = {}
    for crate in sorted({m["crate"] for m in chosen}):
        wanted = sorted({m.get("target", "lib") for m in chosen if m["crate"] == crate})
        flags = [flag for t in wanted for flag in (["--lib"] if t == "lib" else ["--test", t])]
        command = ["cargo", "test", "-p", crate, *flags, "--no-run", "--message-format=json-render-diagnostics"]
        built = subprocess.run(command, cwd=scratch, env=building(scratch), stdout=subprocess.PIPE, text=True)
        if built.returncode:
            sys.exit(f"{crate} does not build with its errors beside it")
        for line in built.stdout.splitlines():
            message = json.loads(line)
            if message.get("executable") and message["profile"]["test"]:
                kind = "lib" if "lib" in message["target"]["kind"] else message["target"]["name"]
                programs[crate, kind] = message["executable"]
    return programs


def building(scratch):
    """The environment of a build: no other copy, and no other checkout, shares its target folder."""
    return {**os.environ, "CARGO_TARGET_DIR": str(scratch.resolve() / "target")}


def run(scratch, targets, crate, target, test, number):
    """Whether the tests whose names hold `test` pass, how many there are, and what they print."""
    environment = {**os.environ, "TRUEGAP_PLANTED": str(number)}
    try:
        done = subprocess.run(
            [targets[crate, target], test], cwd=scratch / "crates" / crate, env=environment, capture_output=True, text=True, timeout=LIMIT
        )
    except subprocess.TimeoutExpired:
        return False, 1, ""
    count = re.search(r"running (\d+) test", done.stdout)
    return done.returncode == 0, int(count.group(1)) if count else 0, done.stdout


def page(rows):
    killed = sum(r["killed"] for r in rows)
    survived = [r for r in rows if not r["killed"]]
    equivalent = sum("equivalent" in r for r in survived)
    share = killed / (len(rows) - equivalent)
    lines = [
        "# Planted errors in core, model, design and diagnosis, and the tests that notice them",
        "",
        f"**{killed} of {len(rows)} killed**" + (f", {equivalent} equivalent" if equivalent else "") + f": {100 * share:.0f} % of those that change an answer.",
        "",
        "Each error is planted alone, and the one test named beside it is run: a test of one stage. `mutants.toml` is the list; `mutants.py` builds a copy of the crates in",
        "which every error can be chosen by number, so that a crate is built once. The finite elements have a list of their own ([mutations](../verification/mutations.md)).",
        "Most tests of the diagnosis stand in the linear Gaussian world (`crates/truegap-diagnose/src/tests/linear`), where evidence, deviations, coverage, errors on rows",
        "left out and probabilities are known from the covariance of all rows. The last column is the commit that an error was last planted in.",
        "",
        "| crate | errors | killed |",
        "|---|---|---|",
    ]
    for crate in CRATES:
        own = [r for r in rows if r["crate"] == crate]
        lines.append(f"| `{crate}` | {len(own)} | {sum(r['killed'] for r in own)} |")
    if survived:
        lines += ["", "Not noticed:", ""]
        lines += [f"- {r['why']} (`{r['file']}`): {r.get('equivalent') or r.get('open', 'no fast test')}" for r in survived]
    lines += ["", "| what is wrong | crate | file | outcome | test | run on |", "|---|---|---|---|---|---|"]
    for r in rows:
        lines.append(f"| {r['why']} | {r['crate'].removeprefix('truegap-')} | `{r['file']}` | {'killed' if r['killed'] else 'not noticed'} | `{r['test']}` | {r['on']} |")
    lines += ["", "Made by `python3 validation/mutants/mutants.py`.", ""]
    return "\n".join(lines)


if __name__ == "__main__":
    main()
