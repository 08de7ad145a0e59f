"""Instructions that commands take, and where: steady on a machine that others use, where times are not.

    python3 benches/instructions.py BINARY                                     # all commands beside benches/instructions.csv; exit code 1 where one takes 3 % more
    python3 benches/instructions.py BINARY --write --by '`cargo build --release -p truegap-cli`'   # writes the file anew
    python3 benches/instructions.py BINARY --only diagnosis

BINARY is a built program with its symbols. Each command runs once under `valgrind --tool=callgrind`, on one thread. Beside its instructions stand the functions that take most of them themselves,
and for a diagnosis the share of its parts with all that they call, so that a regression shows where it is.

Limits: instructions are no time: a division counts as an addition does, and memory that is waited for is free. Counts of two compilers, or of two profiles, are not to be compared.
"""

import argparse
import csv
import pathlib
import re
import subprocess
import sys
import tempfile

FILE = pathlib.Path(__file__).parent / "instructions.csv"
HEADER = ["command", "what", "instructions, 10^6", "what takes most of them", "parts, with all that they call", "program"]
# parts of a diagnosis; one may lie inside of another
PARTS = {
    "derivatives": "Model::refresh",
    "other responses of a model": "Model::residual",
    "fits with one more effect": "Search::add",
    "evidence by sampling": "importance::sampled",
}
# share by which a count may grow before it is a regression
SLACK = 0.03
# functions that are listed
MOST = 4

COMMANDS = {
    "diagnosis": ("the built-in recording, 1 160 rows: one diagnosis", ["-q", "diagnose", "example", "-o", "out"]),
    "simulate": ("20 000 loads of the analytic model, printed", ["-q", "--json", "simulate", "--load", "0:4.5 N:20000"]),
    "tolerance": ("64 sensors and nine tightened tolerances", ["-q", "tolerance", "--samples", "64", "-o", "out"]),
    "sensitivity": ("a Sobol study of 64 rows", ["-q", "sensitivity", "--rows", "64", "-o", "out"]),
}


def short(function: str) -> str:
    """The last two names of a path, without types."""
    function = re.sub(r"\[[^\]]*\]$", "", function).strip().split("/")[-1].split(":", 1)[-1]
    while found := re.search(r"<([^<>]*)>", function):
        # of a trait's own method the trait, of types nothing
        function = function.replace(found.group(0), found.group(1).split(" as ")[-1] if " as " in found.group(1) else "")
    names = [name for name in function.split("::") if name and not re.fullmatch(r"h[0-9a-f]{16}|\{.*\}", name)]
    return "::".join(names[-2:]).replace("'2", "")


def with_called(file: pathlib.Path) -> dict[str, int]:
    """Instructions of each function that is called, with all that it calls."""
    names: dict[str, str] = {}
    found: dict[str, int] = {}
    called = ""
    lines = iter(file.read_text().splitlines())
    for line in lines:
        if known := re.match(r"c?fn=\((\d+)\)(?: (.*))?", line):
            name = names.setdefault(known[1], known[2] or known[1])
            called = name if line.startswith("c") else called
        elif line.startswith("calls="):
            own = int(next(lines).split()[1])
            # a closure runs inside of the function that made it
            if not called.split("'")[0].endswith("{{closure}}"):
                found[short(called)] = found.get(short(called), 0) + own
    return found


def counted(binary: pathlib.Path, arguments: list[str]) -> tuple[int, list[tuple[str, float]], list[tuple[str, float]]]:
    """Instructions of a command, the shares of the functions that take most of them, and those of its parts."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder, "callgrind.out")
        command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", str(binary), *arguments]
        environment = {"RAYON_NUM_THREADS": "1", "PATH": "/usr/local/bin:/usr/bin:/bin", "XDG_CACHE_HOME": folder}
        ran = subprocess.run(command, cwd=folder, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        if ran.returncode not in (0, 1):
            sys.exit(f"{' '.join(arguments)} ended with exit code {ran.returncode}: {ran.stderr[-300:]}")
        text = subprocess.run(["callgrind_annotate", "--threshold=90", str(out)], capture_output=True, text=True, check=True).stdout
        inclusive = with_called(out)
    total = int(re.search(r"^([\d,]+)\s.*PROGRAM TOTALS", text, re.M).group(1).replace(",", ""))
    lines = re.findall(r"^\s*([\d,]+) \([^)]*\)\s+(\S.*)$", text.split("file:function", 1)[-1], re.M)
    shares: dict[str, float] = {}
    for number, function in lines:
        name = short(function)
        shares[name] = shares.get(name, 0.0) + int(number.replace(",", "")) / total
    parts = [(part, inclusive[function] / total) for part, function in PARTS.items() if function in inclusive]
    return total, sorted(shares.items(), key=lambda item: -item[1])[:MOST], parts


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("binary", type=pathlib.Path)
    parser.add_argument("--only", choices=COMMANDS)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--by", default="`cargo build --release -p truegap-cli`", help="how the program was built")
    asked = parser.parse_args()
    before = {}
    if FILE.exists():
        with FILE.open(newline="") as file:
            before = {row["command"]: row for row in csv.DictReader(file)}
    worse = 0
    for name, (what, arguments) in COMMANDS.items():
        if asked.only not in (None, name):
            continue
        total, *shares = counted(asked.binary.resolve(), arguments)
        most, parts = (", ".join(f"{name} {100 * share:.0f} %" for name, share in each) for each in shares)
        line = f"truegap {' '.join(arguments)}: {total / 1e6:.0f} million instructions ({most}; {parts or 'no parts'})"
        if known := before.get(name):
            ratio = total / 1e6 / float(known["instructions, 10^6"])
            is_worse = ratio > 1 + SLACK
            worse += is_worse
            line += f"; {ratio:.3f} of what stands in {FILE.name}{': MORE' if is_worse else ''}"
        print(line, flush=True)
        before[name] = dict(zip(HEADER, [name, what, f"{total / 1e6:.0f}", most, parts, asked.by]))
    if asked.write:
        with FILE.open("w", newline="") as file:
            rows = csv.DictWriter(file, HEADER, lineterminator="\n")
            rows.writeheader()
            rows.writerows(before[name] for name in COMMANDS if name in before)
        return 0
    return 1 if worse else 0


if __name__ == "__main__":
    sys.exit(main())
