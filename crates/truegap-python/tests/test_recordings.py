"""Paths and frames of every kind are the same recording; the same files as the command line."""

from __future__ import annotations

import datetime as dt
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pandas as pd
import polars as pl
import pyarrow
import pytest
import truegap as tg
from conftest import ROOT, command, pressed, spring
from pyarrow import feather

EXAMPLE = ROOT / "validation/recordings/example/recording.toml"


def written(folder: Path) -> Path:
    pd.DataFrame(pressed()).to_csv(folder / "r.csv", index=False)
    toml = 'schema = "truegap.recording/1"\nfile = "r.csv"\n[base]\nmodel = "linear"\n'
    (folder / "r.toml").write_text(toml)
    return folder / "r.toml"


def test_every_kind_of_frame_is_the_same_recording(tmp_path):
    from_file = tg.diagnose(written(tmp_path))
    made = pressed()
    for frame in (made, pd.DataFrame(made), pl.DataFrame(made)):
        d = tg.diagnose(frame, base="linear")
        assert d.table.keys() == from_file.table.keys()
        for name, column in d.table.items():
            assert column == pytest.approx(from_file.table[name], rel=1e-9, abs=1e-9), name
        assert (d.verdict, [p.value for p in d.base_parameters]) == (
            from_file.verdict,
            pytest.approx([p.value for p in from_file.base_parameters], rel=1e-9),
        )


def test_parquet_arrow_and_packed_files_are_the_same_recording(tmp_path):
    made = pd.DataFrame(pressed())
    wanted = tg.diagnose(made, base="linear")
    pl.from_pandas(made).write_parquet(tmp_path / "r.parquet")
    pl.from_pandas(made).write_ipc(tmp_path / "r.arrow")
    feather.write_feather(pyarrow.Table.from_pandas(made), tmp_path / "r.feather")
    for name in ("r.parquet", "r.arrow", "r.feather"):
        d = tg.diagnose(tmp_path / name, base="linear")
        assert [p.value for p in d.base_parameters] == [p.value for p in wanted.base_parameters], name
        assert len(np.asarray(d.predict(tmp_path / name))) == 300
        # named anew, as a frame is
        named = tg.diagnose(tmp_path / name, base="linear", columns={"time": "time_s"}, units={"time": "min"})
        assert named.table["time_s"][1] == 60
    made.to_csv(tmp_path / "r.csv.gz", index=False)
    packed = tg.diagnose(tmp_path / "r.csv.gz", base="linear")
    assert [p.value for p in packed.base_parameters] == pytest.approx([p.value for p in wanted.base_parameters], rel=1e-9)
    done = subprocess.run([command(), "-q", "diagnose", "-", "--base", "linear", "-o", tmp_path / "out"], input=(tmp_path / "r.csv.gz").read_bytes(), check=False)
    assert done.returncode == 0 and (tmp_path / "out/report.html").is_file()


def test_dates_and_durations_are_a_clock(tmp_path):
    """They were refused, whatever frame they stood in."""
    made = pressed()
    wanted = tg.diagnose(made, base="linear")
    seconds = made.pop("time_s")
    start = dt.datetime(2026, 3, 1, 12)
    naive = pd.DataFrame({"time": pd.Timestamp(start) + pd.to_timedelta(seconds, unit="s"), **made})
    aware = naive.assign(time=naive["time"].dt.tz_localize("Europe/Berlin"))
    zone = dt.timezone(dt.timedelta(hours=1))
    objects = [start.replace(tzinfo=zone) + dt.timedelta(seconds=float(s)) for s in seconds]
    frames = {
        "pandas": (naive, "2026-03-01T12:00:00"),
        "pandas with a zone": (aware, "2026-03-01T11:00:00"),
        "polars": (pl.from_pandas(naive), "2026-03-01T12:00:00"),
        "polars with a zone": (pl.from_pandas(aware), "2026-03-01T11:00:00"),
        "pyarrow": (pyarrow.Table.from_pandas(aware), "2026-03-01T11:00:00"),
        "numpy": ({"time": naive["time"].to_numpy(), **made}, "2026-03-01T12:00:00"),
        "objects": ({"time": objects, **made}, "2026-03-01T11:00:00"),
        "durations": ({"time": pd.to_timedelta(seconds, unit="s"), **made}, None),
    }
    for name, (frame, first) in frames.items():
        d = tg.diagnose(frame, base="linear")
        assert d.table["time_s"] == pytest.approx(seconds, abs=1e-6), name
        assert [p.value for p in d.base_parameters] == pytest.approx([p.value for p in wanted.base_parameters], rel=1e-9), name
        told = [note for note in d.notes if "holds dates" in note]
        assert (len(told) == 0) if first is None else (first in told[0]), (name, told)
    days = {"when": [dt.date(2026, 1, 1) + dt.timedelta(days=row) for row in range(300)], **made}
    assert tg.diagnose(days, base="linear", columns={"time": "when"}).table["time_s"][1] == 86_400
    naive.loc[7, "time"] = pd.NaT
    assert len(tg.diagnose(naive, base="linear").table["run"]) == 299


def test_dates_in_a_file_are_those_of_the_frame(tmp_path):
    made = pressed()
    frame = pd.DataFrame({"time": pd.Timestamp("2026-03-01T12:00:00.25") + pd.to_timedelta(made.pop("time_s"), unit="s"), **made})
    frame.to_parquet(tmp_path / "r.parquet", index=False)
    by_file, by_frame = tg.diagnose(tmp_path / "r.parquet", base="linear"), tg.diagnose(frame, base="linear")
    assert list(by_file.table["time_s"]) == list(by_frame.table["time_s"]) and by_file.table["time_s"][0] == 0.25
    (tmp_path / "r.toml").write_text('schema = "truegap.recording/1"\nfile = "r.parquet"\n[base]\nmodel = "linear"\n')
    assert tg.diagnose(tmp_path / "r.toml").document["recording"]["sha256"] == by_file.document["recording"]["sha256"]


def test_a_frame_keeps_the_callers_columns(tmp_path):
    made = pd.DataFrame(pressed())
    before = made.copy()
    made["label"] = "press"
    tg.diagnose(made, base="linear")
    pd.testing.assert_frame_equal(made.drop(columns="label"), before)


def test_rows_with_holes_are_left_out_and_counted():
    made = pressed()
    made["force_n"][7] = np.nan
    d = tg.diagnose(made, base="linear")
    assert any("1 row without a value in `force_n`" in note for note in d.notes)
    assert len(d.table["run"]) == 299


def test_several_recordings_are_diagnosed_together(tmp_path):
    d = tg.diagnose([written(tmp_path), pd.DataFrame(pressed(2))], base="linear")
    assert sorted(set(d.table["recording"])) == [1.0, 2.0]
    assert d.plot().axes[0].get_xlabel() == "" and d.plot().axes[1].get_xlabel() == "row"


def test_a_csv_is_told_what_its_columns_are(tmp_path):
    made = pressed()
    table = pd.DataFrame({"Elapsed": made["time_s"], "Load cell: left": made["force_n"], "read": made["response_mm"]})
    for name in ("plain.csv", "packed.csv.gz"):
        table.to_csv(tmp_path / name, index=False)
        told = {"columns": {"time": "Elapsed", "force": "Load cell: left", "response": "read"}, "units": {"time": "s", "force": "N", "response": "mm"}}
        d = tg.diagnose(tmp_path / name, base="linear", **told)
        assert d.unit == "mm" and np.array_equal(d.table["force_n"], made["force_n"]), name
        assert "--map &quot;force=Load cell: left:N&quot;" in d.report_html() and len(d.predict(tmp_path / name).augmented) == len(made["force_n"])
    with pytest.raises(tg.TruegapError, match="did you mean `read`.*name yours: columns="):
        tg.diagnose(tmp_path / "plain.csv", base="linear", columns={"response": "reads"})
    with pytest.raises(tg.TruegapError, match="say it: units="):
        tg.diagnose(tmp_path / "plain.csv", base="linear", columns={"response": "read", "force": "Elapsed"})


def test_what_cannot_be_read_is_told():
    with pytest.raises(tg.TruegapError, match=r"no-such\.toml"):
        tg.diagnose("no-such.toml")
    with pytest.raises(TypeError, match="is no recording"):
        tg.diagnose(3.0)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="stand in its TOML"):
        tg.diagnose("a.toml", units={"force": "N"})
    with pytest.raises(TypeError, match="stand in its TOML"):
        tg.diagnose("example", columns={"force": "load"})
    with pytest.raises(tg.TruegapError, match="is not in the header|no column"):
        tg.diagnose(pressed(), base="linear", columns={"force": "load"})
    with pytest.raises(tg.TruegapError, match="r.feather.*no such file"):
        tg.diagnose("r.feather", base="linear")
    with pytest.raises(tg.TruegapError, match="neither a sensor nor a base model"):
        tg.diagnose(pressed())


def masked(text: str) -> str:
    """Without what differs between two runs of the same program: the seconds that it took and the minute when."""
    text = re.sub(r'"seconds": [0-9.e+-]+', '"seconds": 0', text)
    text = re.sub(r"\d{4}-\d\d-\d\d \d\d:\d\d UTC", "DATE", text)
    return re.sub(r"(took</td><td>)[0-9.]+ s", r"\1SECONDS", text)


def test_the_same_files_as_the_command_line_byte_for_byte(tmp_path):
    command = os.environ.get("TRUEGAP_COMMAND") or shutil.which("truegap")
    if command is None:
        pytest.fail("the command `truegap` is not there to be compared with; set TRUEGAP_COMMAND to its path")
    for name, recording in (("built-in", "example"), ("own", str(written(tmp_path)))):
        by_command, by_python = tmp_path / f"{name}-command", tmp_path / f"{name}-python"
        done = subprocess.run([command, "--quiet", "diagnose", recording, "-o", by_command], capture_output=True, text=True, check=False)
        assert done.returncode in (0, 1), done.stderr
        tg.diagnose(recording).save(by_python)
        files = sorted(file.name for file in by_command.iterdir())
        assert files == sorted(file.name for file in by_python.iterdir()) and {"augmented.toml", "diagnosis.json", "prediction.csv", "report.html"} <= set(files)
        # the line that says which command made it differs by the words --quiet and -o FOLDER
        spoken = f'truegap --quiet diagnose {recording} -o {by_command}'
        for file in files:
            ours = masked((by_python / file).read_text())
            theirs = masked((by_command / file).read_text()).replace(spoken, f"truegap diagnose {recording}")
            assert ours == theirs, f"{name}: {file}"


def test_the_model_that_was_saved_is_confirmed_as_the_diagnosis_is(tmp_path):
    import tactile_sensor

    d = tactile_sensor.main()
    assert json.loads(json.dumps(d.document))["verdict"] == d.verdict
    d.save(tmp_path / "out")
    if not d.findings:
        pytest.fail(f"the built-in recording has a concealed cause, and none was named: {d.says}")
    with pytest.raises(tg.TruegapError, match="was fitted to this recording"):
        tg.confirm(tmp_path / "out/augmented.toml", "example")
    with pytest.raises(tg.TruegapError, match="was fitted to this recording"):
        d.confirm("example")
    # a prediction takes loads and temperatures with the noise that they were recorded with, the fit without: what differs is noise
    again = d.predict("example")
    name = next(key for key in d.table if key.startswith("augmented_") and "held" not in key)
    off = again.augmented - d.table[name]
    assert abs(np.mean(off)) < 0.1 * d.noise and np.std(off) < d.noise
    assert np.sqrt(np.mean((again.augmented - d.table["recorded_pf"]) ** 2)) < 1.2 * d.noise


def test_a_program_is_a_base_model_from_python_too():
    client = [sys.executable, str(ROOT / "docs/clients/spring.py")]
    known = {"k": {"value": 1.8, "sd": 0.5, "unit": "N/mm", "low": 0.1}, "rest": {"value": 0.0, "sd": 3.0, "unit": "mm"}}
    parameters = {name: tg.Parameter(**p) for name, p in known.items()}
    by_program = tg.diagnose(pressed(), base={"model": "command", "run": client, "parameters": known})
    by_function = tg.diagnose(pressed(), base=spring, parameters=parameters)
    found = [p.value for p in by_program.base_parameters]
    assert found == pytest.approx([p.value for p in by_function.base_parameters], rel=1e-9)
    assert by_program.calls[0] > 10
    with pytest.raises(tg.TruegapError, match="no-such-program.*cannot be started"):
        tg.diagnose(pressed(), base={"model": "command", "run": ["no-such-program"]})


def test_answers_of_a_slow_program_are_kept_where_asked(tmp_path, monkeypatch):
    client = (ROOT / "docs/clients/spring.py").read_text()
    slow = client.replace("        answer = simulate", "        time.sleep(0.015)\n        answer = simulate").replace("import sys", "import sys, time")
    (tmp_path / "sim.py").write_text(slow)
    known = {"k": {"value": 1.8, "sd": 0.5, "unit": "N/mm", "low": 0.1}, "rest": {"value": 0.0, "sd": 3.0, "unit": "mm"}}
    base = {"model": "command", "run": [sys.executable, str(tmp_path / "sim.py")], "parameters": known}
    asked = {"base": base, "effects": ["thermal_lag"], "library_only": True}
    monkeypatch.setenv("TRUEGAP_CACHE", str(tmp_path / "user"))
    first = tg.diagnose(pressed(rows=60), cache=tmp_path / "kept", **asked)
    again = tg.diagnose(pressed(rows=60), cache=tmp_path / "kept", **asked)
    assert again.calls[0] < 0.1 * first.calls[0], (first.calls, again.calls)
    assert [p.value for p in again.base_parameters] == [p.value for p in first.base_parameters]
    assert not (tmp_path / "user").exists()
    tg.diagnose(pressed(rows=60), cache=True, **asked)
    assert list((tmp_path / "user/answers").iterdir())
    with pytest.raises(TypeError, match="answers of a function are not kept"):
        tg.diagnose(pressed(), base=spring, parameters={name: tg.Parameter(**p) for name, p in known.items()}, cache=True)
