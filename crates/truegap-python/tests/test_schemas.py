"""What the command writes, and the files of the repository, keep to the schemas in docs/schemas."""

from __future__ import annotations

import json
import re
import subprocess
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT, command
from jsonschema import Draft202012Validator

try:
    import tomllib
except ModuleNotFoundError:  # Python 3.10
    import tomli as tomllib

SCHEMAS = ROOT / "docs/schemas"
#: Schemas of files that the repository holds.
OF_FILES = {"recording", "sensor", "case", "mechanism", "model", "space"}


@cache
def validator(name: str) -> Draft202012Validator:
    schema = json.loads((SCHEMAS / f"{name}.json").read_text())
    Draft202012Validator.check_schema(schema)
    return Draft202012Validator(schema)


def keeps(name: str, document: Any) -> None:
    wrong = [f"{error.json_path}: {error.message[:200]}" for error in validator(name).iter_errors(document)]
    assert not wrong, f"{name}: {wrong[:5]}"


def prints(name: str, folder: Path, *arguments: str, lines: bool = True) -> None:
    """Runs the command and holds each document that it prints against the schema."""
    done = subprocess.run([command(), "--json", "-q", *arguments], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode < 2, done.stderr
    documents = [json.loads(line) for line in done.stdout.splitlines()] if lines else [json.loads(done.stdout)]
    assert documents
    for document in documents:
        keeps(name, document)
    notices_what_is_wrong(name, documents[0])


def notices_what_is_wrong(name: str, document: Any) -> None:
    """A schema that lets anything pass would be kept to by any output: each value in turn is replaced by one of another kind."""
    if isinstance(document, list):
        document = document[0]
        assert not validator(name).is_valid([{}]), name
    check, wrapped = validator(name), validator(name).is_valid([document])
    for key in document:
        wrong = {**document, key: {"planted": ["error"]}}
        assert not check.is_valid([wrong] if wrapped else wrong), f"{name}: anything passes as `{key}`"


@pytest.mark.parametrize("name", sorted(file.stem for file in SCHEMAS.glob("*.json")))
def test_the_command_prints_the_schema(name):
    done = subprocess.run([command(), "schema", name], capture_output=True, text=True, check=True)
    assert json.loads(done.stdout) == json.loads((SCHEMAS / f"{name}.json").read_text())
    assert not validator(name).is_valid("no document"), f"{name} takes anything"


def test_a_diagnosis_its_model_and_what_the_model_answers(tmp_path):
    prints("diagnosis", tmp_path, "diagnose", "example", "-o", "out")
    keeps("diagnosis", json.loads((tmp_path / "out/diagnosis.json").read_text()))
    keeps("model", tomllib.loads((tmp_path / "out/augmented.toml").read_text()))
    prints("simulate-model", tmp_path, "simulate", "--model", "out/augmented.toml", "--load", "0, 4.5 N")
    # another recording of the same sensor: one row less
    folder = ROOT / "validation/recordings/example"
    (tmp_path / "recording.csv").write_text((folder / "recording.csv").read_text().rstrip().rsplit("\n", 1)[0])
    (tmp_path / "other.toml").write_text((folder / "recording.toml").read_text())
    prints("confirmation", tmp_path, "confirm", "out/augmented.toml", "other.toml")
    prints("compensation", tmp_path, "compensate", "out/augmented.toml", "other.toml")
    prints("firmware", tmp_path, "firmware", "out/augmented.toml")


def test_every_verdict_and_what_it_stands_on_keeps_to_the_schema(tmp_path):
    for name in ("concealed", "bonded"):
        prints("diagnosis", tmp_path, "diagnose", str(ROOT / f"validation/recordings/{name}/recording.toml"), "-o", name)
    prints("diagnosis", tmp_path, "diagnose", "example", "--conceal", "temperature", "-o", "hidden")
    prints("diagnosis", tmp_path, "diagnose", "example", "--effects", "thermal_lag", "--select-in-folds", "-o", "folds")


def test_what_the_analytic_model_answers(tmp_path):
    prints("simulate", tmp_path, "simulate", "--load", "0:4.5 N:3", "--temperature", "20, 50 degC")
    prints("simulate-drive", tmp_path, "simulate", "--drive", "example")
    prints("coefficients", tmp_path, "coefficients")
    prints("explain", tmp_path, "explain", "viscoelastic_creep")
    prints("sensors", tmp_path, "sensors")


def test_a_case_its_mesh_and_a_stack(tmp_path):
    case = str(ROOT / "meshes/cases/coaxial_cable.toml")
    prints("solve", tmp_path, "solve", case)
    prints("mesh", tmp_path, "mesh", case, "-o", "cable.vtu")
    prints("export", tmp_path, "export", "--sensor", "singletact-s15-4.5n", "--load", "4.5 N", "-o", "stack.glb")


def test_the_studies_and_one_assumption_of_the_audit(tmp_path):
    prints("sensitivity", tmp_path, "sensitivity", "--rows", "256")
    prints("tolerance", tmp_path, "tolerance", "--samples", "2000", "--limit", "span=2.3:2.6")
    prints("optimise", tmp_path, "optimise", "--searches", "1")
    prints("audit", tmp_path, "audit", "--sensor", "foam-s15", "--only", "SERIES-OF-INTEGRALS", "-o", "a")


def test_a_space_of_designs_and_what_its_audit_says(tmp_path):
    space = 'schema = "truegap.space/1"\nsensor = "singletact-s15-4.5n"\ndesigns = 2\nonly = ["TAIL-PARALLEL-PLATE"]\n[axes]\nheight = "150 um:210 um"\n'
    keeps("space", tomllib.loads(space))
    (tmp_path / "space.toml").write_text(space)
    prints("audit-space", tmp_path, "audit", "--space", "space.toml", "-o", "space")
    keeps("audit-space", json.loads((tmp_path / "space/audit-space.json").read_text()))


def test_a_blind_study(tmp_path):
    prints("prove", tmp_path, "prove", "--cases", "2", "--seed", "1", "-o", "study", lines=False)
    keeps("prove", json.loads((tmp_path / "study/score.json").read_text()))


def test_every_toml_of_the_repository_keeps_to_its_schema():
    seen: dict[str, int] = {}
    for folder in ("meshes", "validation/recordings", "validation/attack/corpus", "docs"):
        for file in sorted((ROOT / folder).rglob("*.toml")):
            try:
                document = tomllib.loads(file.read_text())
            except (tomllib.TOMLDecodeError, UnicodeDecodeError):
                continue
            name, _, version = str(document.get("schema", "")).removeprefix("truegap.").partition("/")
            if version == "1" and (SCHEMAS / f"{name}.json").is_file():
                seen[name] = seen.get(name, 0) + 1
                keeps(name, document)
    assert set(seen) == OF_FILES, seen


def test_every_schema_is_held_against_a_document():
    held = set(re.findall(r"(?:prints|keeps)\(\"([a-z-]+)\"", Path(__file__).read_text())) | OF_FILES
    assert held == {file.stem for file in SCHEMAS.glob("*.json")}


WHOLE = {"schema": "truegap.recording/1", "file": "a.csv"}
REFUSED = [
    ("recording", {"schema": "truegap.recording/1"}),
    ("recording", {**WHOLE, "columns": {"load": "F"}}),
    ("recording", {**WHOLE, "base": {"model": "stak"}}),
    ("recording", {**WHOLE, "schema": "truegap.recording/2"}),
    ("recording", {**WHOLE, "drivers": {"pump": {"colum": "p"}}}),
    ("recording", {**WHOLE, "dayfirst": "yes"}),
    ("case", {"schema": "truegap.case/1", "physics": "electrostatics"}),
    ("space", {"schema": "truegap.space/1", "sensor": "singletact-s15-4.5n", "designs": "two"}),
]


@pytest.mark.parametrize(("name", "document"), REFUSED)
def test_what_the_readers_refuse_for_its_shape_is_refused(name, document):
    assert not validator(name).is_valid(document)
    keeps("recording", {**WHOLE, "columns": {"force": "F"}, "drivers": {"pump": {"column": "p", "unit": "V"}}})
