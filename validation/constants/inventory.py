"""The list in constants.toml: read, checked against the sources, and what each number is turned to.

Limits: values of whole numbers, floats, arrays and pairs of these.
"""

import re
import sys
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SOURCES = ROOT / "crates/truegap-diagnose/src"


def constants():
    """All entries in the order of the list, each with file, stage and an id such as `selection.SURE`."""
    listed = tomllib.loads((HERE / "constants.toml").read_text())["file"]
    entries = [{**c, "path": f["path"], "stage": f["stage"]} for f in listed for c in f["constants"]]
    for entry in entries:
        stem = entry["path"].removesuffix(".rs").removesuffix("/tuning").replace("/", ".")
        entry["id"] = f"{stem}.{entry['name']}"
    return entries


def place(entry):
    """Text before the value, the value as it stands, text after it; a `const` where the entry names no other text."""
    if "at" not in entry:
        found = re.search(rf"\bconst {entry['name']}: [^=]+? =\s*([^;]+);", (SOURCES / entry["path"]).read_text())
        if not found:
            return None
        return "", re.sub(r"\s+", " ", found.group(1)), ""
    if "to" in entry:
        return "", entry["value"], entry["at"]
    before, value, after = re.fullmatch(r"(?s)(.*)«(.*)»(.*)", entry["at"]).groups()
    return before, value, after


def differences():
    """What the list says of the sources that is not so."""
    wrong = []
    for entry in constants():
        stands = place(entry)
        if stands is None:
            wrong.append(f"{entry['id']}: no such constant in {entry['path']}")
        elif stands[1] != entry["value"]:
            wrong.append(f"{entry['id']}: {stands[1]} stands in {entry['path']}, {entry['value']} in the list")
        elif "at" in entry and (SOURCES / entry["path"]).read_text().count(stands[0] + ("" if "to" in entry else stands[1]) + stands[2]) != 1:
            wrong.append(f"{entry['id']}: its text does not stand once in {entry['path']}")
    return wrong


def numbers(text):
    """The numbers of a value, in order."""
    return [eval(part, {"__builtins__": {}}) for part in re.sub(r"[\[\]()]", "", text).split(",")]


def is_whole(entry):
    """Whether it counts something."""
    return entry.get("whole", False) or all(isinstance(n, int) for n in numbers(entry["value"]))


def turned(entry, factor):
    """The numbers of an entry, halved (factor 0.5) or doubled (2)."""
    said = entry.get("halved" if factor < 1 else "doubled")
    if said:
        return numbers(said)
    about = entry.get("about", 0.0)
    values = [about + factor * (n - about) for n in numbers(entry["value"])]
    return [max(1, int(v)) if is_whole(entry) else float(f"{v:.6g}") for v in values]


def check():
    """Ends with the differences, where there are any."""
    wrong = differences()
    if wrong:
        sys.exit("\n".join(wrong))
