"""Recordings that are diagnosed for every constant, and what is read off an answer.

Limits: one thread a diagnosis; a recording counts by its verdict, its names and its error on rows left out.
"""

import json
import math
import os
import subprocess
import sys
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
LIMIT = 900  # s; a turned constant may make a search long


def recordings(scratch):
    """The battery with the path of each recording, resolved through TRUEGAP_RECORDINGS and TRUEGAP_PACKAGES; those of fewer rows are written to `scratch`."""
    listed = tomllib.loads((HERE / "battery.toml").read_text())["recording"]
    roots = {source: folder_of(source) for source in sorted({one["source"] for one in listed} - {"built in"})}
    for one in listed:
        if one["source"] == "built in":
            one["given"] = "example"
            continue
        folder = roots[one["source"]]
        one.setdefault("file", f"{one['name']}/{one['name']}.toml")
        one["given"] = str(thinned(folder / one["file"], one["every"], scratch / one["name"]) if "every" in one else folder / one["file"])
    return listed


def folder_of(source):
    """The folder of recordings of a source."""
    name, of = {
        "real": ("TRUEGAP_RECORDINGS", "recordings (docs/recordings.md)"),
        "generated": ("TRUEGAP_RECORDINGS", "recordings (docs/recordings.md)"),
        "package": ("TRUEGAP_PACKAGES", "recordings that ship inside packages (validation/recordings/packages/fetch.py)"),
    }[source]
    if not os.environ.get(name):
        sys.exit(f"{name} names no folder of {of}")
    root = Path(os.environ[name])
    return root.parent / "blind" if source == "generated" else root


def thinned(description, every, folder):
    """The recording with one row of so many, beside its description."""
    text = description.read_text()
    name = tomllib.loads(text)["file"]
    rows = (description.parent / name).read_text().splitlines()
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_text("\n".join([rows[0], *rows[1::every]]) + "\n")
    (folder / description.name).write_text(text)
    return folder / description.name


def diagnose(program, given, out, turn=None, reads=None):
    """Diagnoses once; the text of diagnosis.json, `None` where there is no answer."""
    environment = {**os.environ, "RAYON_NUM_THREADS": "1"}
    environment |= {"TRUEGAP_TURN": turn} if turn else {}
    environment |= {"TRUEGAP_READS": str(reads)} if reads else {}
    command = [str(program), "diagnose", given, "-o", str(out)]
    try:
        subprocess.run(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=LIMIT)
        return (out / "diagnosis.json").read_text()
    except (subprocess.TimeoutExpired, FileNotFoundError):
        return None


def without_seconds(text):
    """An answer without the time that it took."""
    return "\n".join(line for line in text.splitlines() if not line.lstrip().startswith('"seconds":'))


def answer(text):
    """Verdict, names, sets, probabilities and error on rows left out of an answer."""
    if text is None:
        return {"verdict": "no answer", "names": [], "sets": [], "probability": [], "agrees": None, "held_out": None}
    said = json.loads(text)
    held_out = said["fit"]["held_out"]
    return {
        "verdict": said["verdict"],
        "names": sorted(f["effect"] for f in said["findings"]),
        "sets": sorted(sorted(s) for s in said["ambiguity"]),
        "probability": sorted(round(f["probability"], 4) for f in said["findings"]),
        "agrees": float(f"{said['probability_agrees']:.3g}"),
        "held_out": held_out["rmse_after"] if said["findings"] else held_out["rmse_before"],
    }


def names(found):
    """All that is named, with what stands in its place."""
    return {tuple(found["names"]), *(tuple(s) for s in found["sets"])}


def change(before, after):
    """Factor of the error on rows left out, as a natural logarithm; 0 where either has none."""
    if not before["held_out"] or not after["held_out"]:
        return 0.0
    return math.log(after["held_out"] / before["held_out"])


def is_right(truth, found):
    """Whether an answer is right or right within its sets, as the blind studies score; `None` where no truth is known. A truth with `|` or `;` in it is a list of names for each cause, as those of real recordings
    are written down."""
    if truth == "unknown":
        return None
    if "|" in truth or ";" in truth:
        return holds_all([set(cause.split("|")) for cause in truth.split(";")], found)
    own = set(found["names"])
    if truth == "nothing":
        return found["verdict"] == "agrees"
    if truth == "not in the library":
        return found["verdict"] in ("unexplained", "undecided") or (bool(own) and all(n.startswith("discovered") for n in own))
    causes = set(truth.split(" + "))
    held = own | {name for s in found["sets"] for name in s}
    return own == causes or (found["verdict"] == "ambiguous" and causes <= held)


def holds_all(causes, found):
    """Whether each cause is told, by one of its names or a set that holds one, and nothing else is."""
    told = [next((set(s) for s in found["sets"] if name in s), {name}) for name in found["names"]]
    if not told:
        return found["verdict"] == "agrees" and any("agrees" in cause for cause in causes)
    missing = [cause - {"agrees"} for cause in causes if cause != {"agrees"}]
    return all(any(t & cause for t in told) for cause in missing) and all(any(t & cause for cause in missing) for t in told)
